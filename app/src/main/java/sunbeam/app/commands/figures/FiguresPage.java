package sunbeam.app.commands.figures;

import java.util.List;
import java.util.Map;
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

    /** @param drawn what there is, by the picture's file */
    static String of(List<Figure> figures, Map<String, Drawn> drawn) {
        StringBuilder html = new StringBuilder(START);
        html.append(paragraph(
                "The figures of M. Single's thesis \"An Interactive Shader for Natural Diffraction Gratings\" (Bern"
                        + " 2014), computed anew by Sunbeam " + Version.number()
                        + ". Light along the normal and one coherence area of"
                        + " 65 um (sigma_s 16.25 um), centred, unless the caption says otherwise."));
        for (Figure figure : figures) {
            StringBuilder rows = new StringBuilder();
            figure.patches().forEach(patch -> rows.append(row(figure, patch, drawn)));
            if (!rows.isEmpty()) {
                html.append("<h2>Figure ").append(escape(figure.number() + ": " + figure.title()));
                html.append("</h2>\n").append(paragraph(figure.text())).append(rows);
            }
        }
        return html.append("</body>\n</html>\n").toString();
    }

    private static String row(Figure figure, String patch, Map<String, Drawn> drawn) {
        StringBuilder row = new StringBuilder();
        for (Figure.Picture picture : figure.pictures()) {
            String file = figure.file(patch, picture);
            if (drawn.containsKey(file)) {
                row.append(picture(file, patch + ": " + picture.label(), drawn.get(file)));
            }
        }
        return row.isEmpty() ? "" : "<div class=\"row\">\n" + row + "</div>\n";
    }

    private static String picture(String file, String label, Drawn drawn) {
        String wide = drawn.command().startsWith("evaluate") ? " class=\"wide\"" : "";
        String caption = drawn.caption().isEmpty() ? label : label + "; " + drawn.caption();
        return "<figure" + wide + "><a href=\"" + escape(file) + "\"><img src=\"" + escape(file) + "\" alt=\""
                + escape(label)
                + "\"></a><figcaption>" + escape(caption) + "<br><code>" + escape(drawn.command())
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
