package sunbeam.app.cli.figures;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import sunbeam.app.gpu.picture.PictureDifference;
import sunbeam.app.terminal.Environment;

/** Writes index.html: each figure with its pictures, captions and commands. */
final class FiguresPage {
    /** Line by which a page written by this command is recognized. */
    static final String GENERATOR = "<meta name=\"generator\" content=\"Sunbeam figures\">\n";

    private static final String TEMPLATE = "page.html";

    private FiguresPage() {}

    static String of(List<Figure> figures, List<Figure.Drawing> drawings, Path folder) {
        StringBuilder html = new StringBuilder();
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
        try (InputStream stream = FiguresPage.class.getResourceAsStream(TEMPLATE)) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8)
                    .replace("@VERSION@", Environment.version())
                    .replace("@FIGURES@", html);
        } catch (IOException failure) {
            throw new UncheckedIOException(TEMPLATE, failure);
        }
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
                        + PictureDifference.of(Measure.image(drawing.file()), Measure.image(base))
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

    private static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
