package sunbeam.app.commands.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import sunbeam.app.terminal.Version;

/** The folder's index.html: each figure with its pictures and captions, and Table 4.1. */
final class FiguresPage {
    private static final String STYLE = """
            body { background: #16181c; color: #ddd; font: 15px/1.4 sans-serif; margin: 2em auto; max-width: 1400px; }
            h1, h2 { color: #fff; } h2 { margin-top: 2.5em; } a { color: #8cf; }
            .panels { display: flex; flex-wrap: wrap; gap: 1em; }
            figure { margin: 0; width: 256px; } figure.wide { width: 680px; }
            figure.band { width: 512px; } figure.band img { height: 80px; object-fit: cover; }
            figure img { width: 100%; } figcaption { font-size: 12px; color: #aaa; }
            table { border-collapse: collapse; } td, th { padding: 0.2em 1em; text-align: right; border: 1px solid #444; }
            """;
    private static final String ROW_HEADER =
            "patch,azimuth / degrees,mean d on samples / nm,variance / nm^2,mean d interpolated / nm,variance / nm^2";

    /** Tells a page of this program from others. */
    static final String GENERATOR = "<meta name=\"generator\" content=\"Sunbeam figures\">\n";

    private final StringBuilder html = new StringBuilder();

    /** @param texts of the pictures that there are */
    static String of(List<Figure> figures, Map<Panel, Map<String, String>> texts) {
        FiguresPage page = new FiguresPage();
        page.write(figures, texts);
        return page.html.toString();
    }

    private void write(List<Figure> figures, Map<Panel, Map<String, String>> texts) {
        html.append(
                        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Result figures</title>\n")
                .append(GENERATOR)
                .append("<style>\n")
                .append(STYLE)
                .append("</style>\n</head>\n<body>\n<h1>Result figures</h1>\n");
        paragraph("The figures of M. Single's thesis \"An Interactive Shader for Natural Diffraction Gratings\" (Bern"
                + " 2014), computed anew by Sunbeam " + Version.number() + ". Light along the normal and one coherence"
                + " area of 65 um (sigma_s 16.25 um), centred, unless the caption says otherwise. A difference is told"
                + " against the first picture of the same patch, whose exposure is taken too.");
        for (Figure figure : figures) {
            List<Panel> there =
                    figure.panels().stream().filter(texts::containsKey).toList();
            if (!there.isEmpty()) {
                section(figure, there, texts);
            }
        }
        table(figures, texts);
        html.append("</body>\n</html>\n");
    }

    private void section(Figure figure, List<Panel> panels, Map<Panel, Map<String, String>> texts) {
        html.append("<h2 id=\"f").append(figure.number()).append("\">Figure ");
        html.append(escape(figure.number() + ": " + figure.title())).append("</h2>\n");
        paragraph(figure.text());
        for (List<Panel> row : rows(panels)) {
            html.append("<div class=\"panels\">\n");
            for (Panel panel : row) {
                picture(panel, texts.get(panel).getOrDefault(PanelStore.CAPTION, panel.label()));
            }
            html.append("</div>\n");
        }
    }

    /** One row for each patch. */
    private static List<List<Panel>> rows(List<Panel> panels) {
        List<List<Panel>> rows = new ArrayList<>();
        for (Role role : Role.values()) {
            List<Panel> row =
                    panels.stream().filter(panel -> panel.role() == role).toList();
            if (!row.isEmpty()) {
                rows.add(row);
            }
        }
        return rows;
    }

    private void picture(Panel panel, String caption) {
        String file = escape(panel.name() + ".png");
        html.append(String.format(Locale.ROOT, "<figure%s>", style(panel)))
                .append(String.format(
                        Locale.ROOT,
                        "<a href=\"%s\"><img src=\"%s\" alt=\"%s\"></a>",
                        file,
                        file,
                        escape(panel.label())))
                .append("<figcaption>")
                .append(escape(panel.role().label() + ": " + caption))
                .append("</figcaption></figure>\n");
    }

    /** The blazed grating's orders lie on a line, which is shown larger. */
    private static String style(Panel panel) {
        if (panel instanceof Panel.ResponsePanel) {
            return " class=\"wide\"";
        }
        return panel.role() == Role.BLAZE ? " class=\"band\"" : "";
    }

    private void table(List<Figure> figures, Map<Panel, Map<String, String>> texts) {
        List<String> rows = rowsOfTable(figures, texts);
        if (rows.isEmpty()) {
            return;
        }
        html.append("<h2 id=\"t4.1\">Table 4.1: periods by the grating equation</h2>\n<table>\n");
        row(ROW_HEADER, "th");
        rows.forEach(line -> row(line, "td"));
        html.append("</table>\n");
        paragraph("The thesis has, for its patches: blaze 2500.34 nm, variance 0.16; Elaphe 1144.28, 0.15; Xenopeltis"
                + " 1552.27 (azimuth not stated). A skin's figure belongs to one coherence area; sunbeam evaluate"
                + " --positions N tells how it is distributed.");
    }

    /** The table as CSV, with its header. */
    static List<String> tableLines(List<Figure> figures, Map<Panel, Map<String, String>> texts) {
        List<String> rows = rowsOfTable(figures, texts);
        List<String> lines = new ArrayList<>();
        if (!rows.isEmpty()) {
            lines.add(ROW_HEADER);
            lines.addAll(rows);
        }
        return lines;
    }

    private static List<String> rowsOfTable(List<Figure> figures, Map<Panel, Map<String, String>> texts) {
        return figures.stream()
                .flatMap(figure -> figure.panels().stream())
                .filter(panel -> texts.containsKey(panel) && texts.get(panel).containsKey(ResponseDrawer.ROW))
                .map(panel -> texts.get(panel).get(ResponseDrawer.ROW))
                .collect(Collectors.toList());
    }

    private void row(String line, String cell) {
        html.append("<tr>");
        for (String value : line.split(",", -1)) {
            html.append(String.format(Locale.ROOT, "<%s>%s</%s>", cell, escape(value), cell));
        }
        html.append("</tr>\n");
    }

    private void paragraph(String text) {
        html.append("<p>").append(escape(text)).append("</p>\n");
    }

    private static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
