"""Called by paraview_call.py: pvbatch draw.py PLAN.json

Writes what was found beside the plan, as PLAN.json.done. Nothing else is defined
here: filters in Python put their names into the script that is called.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from taut_render import drawing  # noqa: E402

plan_file = Path(sys.argv[1])
found_out = drawing.draw(json.loads(plan_file.read_text(encoding="utf-8")))
plan_file.with_name("plan.json.done").write_text(json.dumps(found_out),
                                                 encoding="utf-8")
