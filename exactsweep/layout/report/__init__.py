"""Reports of judged layouts: a table, a picture, a page."""

from exactsweep.layout.report.page import write_layout_page
from exactsweep.layout.report.picture import LayoutPicture, draw_layout
from exactsweep.layout.report.table import report_layout, write_layout_json
from exactsweep.layout.report.worst import ReportContext, WorstFirst, rank_faults

__all__ = [
    "LayoutPicture",
    "ReportContext",
    "WorstFirst",
    "draw_layout",
    "rank_faults",
    "report_layout",
    "write_layout_json",
    "write_layout_page",
]
