package sunbeam.app.cli.figures;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.gpu.picture.PictureDifference;
import sunbeam.app.terminal.Version;

/** Writes index.html: each figure with its pictures, captions and commands. */
final class FiguresPage {
    /** Line by which a page written by this command is recognized. */
    static final String GENERATOR = "<meta name=\"generator\" content=\"Sunbeam figures\">\n";

    private static final String START = """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <title>Result figures</title>
            """ + GENERATOR + """
            <style>
            body { background: #16181c; color: #ddd; font: 15px/1.4 sans-serif; margin: 2em auto; max-width: 1400px; }
            h1, h2 { color: #fff; } h2 { margin-top: 2.5em; } a { color: #8cf; }
            .row { display: flex; flex-wrap: wrap; gap: 1em; margin-bottom: 1em; }
            figure { margin: 0; width: 536px; } figure.map { width: 256px; } table { border-collapse: collapse; } td, th { padding: 2px 12px; text-align: left; } figure img { width: 100%; }
            figure.map img { border-radius: 50%; box-shadow: 0 0 0 1px #777; }
            figcaption, code { font-size: 12px; color: #aaa; }
            </style>
            </head>
            <body>
            <h1>Result figures</h1>
            """;

    private FiguresPage() {}

    static String of(List<Figure> figures, List<Figure.Drawing> drawings, Path folder) {
        StringBuilder html = new StringBuilder(START);
        html.append(
                paragraph(
                        "The figures of M. Single's thesis \"An Interactive Shader for Natural Diffraction Gratings\" (Bern"
                                + " 2014), computed anew by Sunbeam " + Version.number()
                                + ". Light along the normal and one coherence area of"
                                + " 65 um (sigma_s 16.25 um), centered, unless the caption says otherwise. Verdicts are of the measured"
                                + " patches (--patches FOLDER); the built-in elaphe-like and xenopeltis-like have other periods."));
        for (Figure figure : figures) {
            html.append("<h2>").append(escape(figure.heading())).append("</h2>\n<p>");
            html.append("<b>Thesis:</b> ").append(escape(figure.thesis())).append("<br><b>Here:</b> ");
            html.append(escape(figure.ours())).append("<br><b>Check:</b> ");
            html.append(escape(
                    figure.verdict(drawings).map(Check.Verdict::toString).orElse("a picture or a number is missing")));
            html.append("</p>\n").append(table(figure, drawings));
            for (String patch : figure.rows()) {
                html.append("<div class=\"row\">\n");
                figure.own(drawings).stream()
                        .filter(drawing -> drawing.patch().equals(patch)
                                && !drawing.picture().hidden()
                                && Files.isRegularFile(drawing.file()))
                        .forEach(drawing -> html.append(picture(drawing, folder)));
                html.append("</div>\n");
            }
        }
        return html.append("</body>\n</html>\n").toString();
    }

    /** Returns a table of the thesis's numbers and Sunbeam's; an empty text if the figure has none. */
    private static String table(Figure figure, List<Figure.Drawing> drawings) {
        List<List<String>> rows = figure.own(drawings).stream()
                .flatMap(drawing -> drawing.numbers().stream())
                .toList();
        if (rows.isEmpty()) {
            return "";
        }
        StringBuilder html = new StringBuilder(
                "<table><tr><th>patch</th><th></th><th>thesis</th><th>here</th><th>difference</th></tr>\n");
        for (List<String> row : rows) {
            html.append("<tr>");
            row.forEach(cell -> html.append("<td>").append(escape(cell)).append("</td>"));
            html.append("</tr>\n");
        }
        return html.append("</table>\n").toString();
    }

    private static String picture(Figure.Drawing drawing, Path folder) {
        String kind = drawing.isMap() ? " class=\"map\"" : "";
        String file = escape(folder.relativize(drawing.file()).toString().replace('\\', '/'));
        String label = (drawing.patch().isEmpty() ? "" : drawing.patch() + ": ")
                + drawing.picture().label();
        String difference = drawing.base()
                .filter(Files::isRegularFile)
                .map(base -> "; "
                        + PictureDifference.of(
                                        ImageFile.ours(drawing.file(), "remove it"), ImageFile.ours(base, "remove it"))
                                .text()
                        + " from the first")
                .orElse("");
        return "<figure" + kind + "><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + escape(label)
                + "\"></a><figcaption>" + escape(label + difference) + "<br><code>"
                + escape(
                        drawing.command().isEmpty()
                                ? ""
                                : "./sunbeam " + String.join(" ", drawing.command()) + " --force")
                + "</code></figcaption></figure>\n";
    }

    private static String paragraph(String text) {
        return "<p>" + escape(text) + "</p>\n";
    }

    private static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
