package sunbeam.app.commands.figures;

import java.nio.file.Files;
import java.util.List;
import sunbeam.app.terminal.Version;

/** The folder's index.html: each figure with its pictures, their captions and the commands that draw them. */
final class FiguresPage {
    /** Tells a page of this program from others. */
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
            figure { margin: 0; width: 256px; } figure.wide { width: 680px; } figure img { width: 100%; }
            figcaption, code { font-size: 12px; color: #aaa; }
            </style>
            </head>
            <body>
            <h1>Result figures</h1>
            """;

    private FiguresPage() {}

    /** @param drawings of these figures; those that are not there are left out */
    static String of(List<Figure> figures, List<Figure.Drawing> drawings) {
        StringBuilder html = new StringBuilder(START);
        html.append(paragraph(
                "The figures of M. Single's thesis \"An Interactive Shader for Natural Diffraction Gratings\" (Bern"
                        + " 2014), computed anew by Sunbeam " + Version.number()
                        + ". Light along the normal and one coherence area of"
                        + " 65 um (sigma_s 16.25 um), centered, unless the caption says otherwise."));
        for (Figure figure : figures) {
            html.append("<h2>Figure ").append(escape(figure.number() + ": " + figure.title()));
            html.append("</h2>\n").append(paragraph(figure.text()));
            for (String patch : figure.patches()) {
                html.append("<div class=\"row\">\n");
                drawings.stream()
                        .filter(drawing -> drawing.number().equals(figure.number())
                                && drawing.patch().equals(patch)
                                && Files.isRegularFile(drawing.file()))
                        .forEach(drawing -> html.append(picture(drawing)));
                html.append("</div>\n");
            }
        }
        return html.append("</body>\n</html>\n").toString();
    }

    private static String picture(Figure.Drawing drawing) {
        String wide = drawing.command().get(0).equals("evaluate") ? " class=\"wide\"" : "";
        String file = escape(drawing.file().getFileName().toString());
        String label = drawing.patch() + ": " + drawing.label();
        String difference = drawing.base()
                .filter(Files::isRegularFile)
                .map(base -> "; " + PictureDifference.of(drawing.file(), base).text())
                .orElse("");
        return "<figure" + wide + "><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + escape(label)
                + "\"></a><figcaption>" + escape(label + difference) + "<br><code>"
                + escape(String.join(" ", drawing.command())) + "</code></figcaption></figure>\n";
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
