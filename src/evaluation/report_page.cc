// SPDX-FileCopyrightText: 2026 The yorb-slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/report_page.h"

#include "evaluation/svg.h"

namespace yorb {

const char* ReportStyle() {
  return R"(
:root{--ink:#1f2430;--faint:#5b6270;--paper:#ffffff;--ground:#f4f5f8;--line:#e3e6eb;--frame:#9aa1ad;--accent:#0072b2;--soft:#b9d9ea}
@media screen and (prefers-color-scheme:dark){:root{--ink:#e8eaf0;--faint:#a3aab8;--paper:#1c2029;--ground:#12151b;--line:#323846;--frame:#5d6575;--accent:#4ba3d6;--soft:#274a5e}
svg [stroke="#0072b2"]{stroke:#4ba3d6}svg [fill="#0072b2"]{fill:#4ba3d6}}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:15px/1.5 "Helvetica Neue",Helvetica,Arial,"Liberation Sans","DejaVu Sans",sans-serif;-webkit-print-color-adjust:exact;print-color-adjust:exact}
main{max-width:960px;margin:0 auto;padding:28px 20px 40px}
h1{font-size:26px;line-height:1.25;margin:0 0 4px;overflow-wrap:anywhere}
h2{font-size:17px;margin:0 0 12px}
.sub{color:var(--faint);margin:0 0 20px;overflow-wrap:anywhere}
section{background:var(--paper);border:1px solid var(--line);border-radius:8px;padding:18px 22px 14px;margin:0 0 18px;break-inside:avoid}
.cards{display:grid;grid-template-columns:repeat(auto-fill,minmax(150px,1fr));gap:12px;margin:0 0 18px}
.card{background:var(--paper);border:1px solid var(--line);border-radius:8px;padding:12px 16px;break-inside:avoid}
.card b{display:block;font-size:21px;line-height:1.3;font-variant-numeric:tabular-nums;overflow-wrap:anywhere}
.card span{color:var(--faint);font-size:13px}
svg{display:block;width:100%;height:auto;margin:0 0 8px}
svg .paper{fill:var(--paper)} svg .ink{fill:var(--ink)} svg .faint{fill:var(--faint)}
svg .grid{stroke:var(--line)} svg .frame{stroke:var(--frame)}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:6px 10px;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th{color:var(--faint);font-weight:600;font-size:13px}
th:first-child,td:first-child{text-align:left;padding-left:0} th:last-child,td:last-child{padding-right:0}
tr:last-child td{border-bottom:0}
td.bar{width:38%;padding-left:18px}
.track{position:relative;height:14px;background:var(--ground);border-radius:3px;overflow:hidden}
.track i{position:absolute;left:0;top:0;bottom:0;border-radius:3px}
.track .p95{background:var(--soft)} .track .median{background:var(--accent)}
.scroll{overflow-x:auto}
.hint{color:var(--faint);font-size:13px;margin:8px 0 4px}
ul{margin:0 0 6px;padding-left:20px} li{overflow-wrap:anywhere}
footer{color:var(--faint);font-size:13px;overflow-wrap:anywhere}
)";
}

std::string ReportSection(const std::string& title, const std::string& content) {
  if (content.empty()) return {};
  return "<section>\n<h2>" + EscapeXml(title) + "</h2>\n" + content + "</section>\n";
}

std::string ReportCard(const std::string& label, const std::string& value) {
  return "<div class=\"card\"><b>" + EscapeXml(value) + "</b><span>" + EscapeXml(label) + "</span></div>\n";
}

std::string ReportPage(const std::string& title, const std::string& subtitle, const std::string& content,
                       const std::string& footer) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         EscapeXml(title) + "</title>\n<style>" + ReportStyle() + "</style>\n</head>\n<body>\n<main>\n<h1>" +
         EscapeXml(title) + "</h1>\n<p class=\"sub\">" + EscapeXml(subtitle) + "</p>\n" + content + "<footer>" +
         EscapeXml(footer) + "</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace yorb
