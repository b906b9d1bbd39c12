package sunbeam.app.cli.figures;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import sunbeam.app.cli.Collection;
import sunbeam.app.cli.FileCommand;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.work.Progress;

/** Command {@code sunbeam figures}: runs the commands of the manifest, one per picture, and writes a page of them. */
@Command(
        name = "figures",
        header = "Draw the thesis's figures and Table 4.1 as one folder with a page.",
        description =
                "Draw the figures of the thesis, by its own numbers, as one folder: each with what the thesis shows in it, what"
                        + " is seen here, and whether a measurement of the pictures agrees; Table 4.1 with the thesis's numbers, ours"
                        + " and the difference. Existing"
                        + " pictures that were drawn with the same options are kept, so a stopped run can be continued. Look at index.html, which names the command of each picture.",
        footer = {"  sunbeam figures --only 5.10,table-4.1"})
public final class FiguresCommand extends FileCommand {
    private static final int LARGEST = 2048;
    private static final int STANDARD = 224;
    private static final int QUICK = 96;
    private static final String PAGE = "index.html";
    private static final Map<String, String> BUILT_IN =
            Map.of("blaze", "blaze", "elaphe", "elaphe-like", "xenopeltis", "xenopeltis-like");

    private final ProgressDisplay display;
    private final Function<List<String>, Collection.Outcome> runner;

    @Option(
            names = "--output",
            paramLabel = "FOLDER",
            defaultValue = "figures",
            description = "The folder, made where it is missing. Default: ${DEFAULT-VALUE}.")
    private Path output;

    @Option(
            names = "--only",
            paramLabel = "NUMBER",
            split = ",",
            description = "Only these figures, for example 5.10, or 5.3,table-4.1.")
    private List<String> only = new ArrayList<>();

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            description = "Width and height of each map, 16 to 2048. Default: 224, with --quick 96.")
    private Integer size;

    @Option(
            names = "--quick",
            description = "Draw maps of 96 pixels, scenes of 160 x 120 and responses in steps of 10 nm.")
    private boolean quick;

    @Option(
            names = "--patches",
            paramLabel = "FOLDER",
            description = "Folder with the measured patches blaze.json, elaphe.json and xenopeltis.json. Default: the"
                    + " built-in patches blaze, elaphe-like and xenopeltis-like.")
    private Path patchFolder;

    /** @param runner function that runs a command line of this program */
    public FiguresCommand(ProgressDisplay display, Function<List<String>, Collection.Outcome> runner) {
        this.display = display;
        this.runner = runner;
    }

    @Override
    public Integer call() {
        int side = size != null ? size : quick ? QUICK : STANDARD;
        UsageException.requireWithin("--size", side, 16, LARGEST);
        Figure.Sizes sizes = new Figure.Sizes(side, quick ? "160x120" : "360x270", quick ? "380:780:10" : "380:780:2");
        Map<Figure, List<Figure.Drawing>> drawings = new LinkedHashMap<>();
        Figure.select(only).forEach(figure -> drawings.put(figure, figure.drawings(this::source, sizes, output)));
        OutputFolder.createWithParents(output);
        String options = options(drawings, sizes);
        checkPage(options);
        int code = draw(drawings);
        AtomicFile.write(output.resolve(PAGE), Overwrite.REPLACE, StreamContent.of(page(drawings, options)));
        List<Map<String, Object>> verdicts = new ArrayList<>();
        List<List<String>> numbers = new ArrayList<>();
        drawings.forEach((figure, own) -> {
            Check.Verdict verdict = figure.verdict(own);
            json.text(out()).println(figure.number() + " " + verdict);
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("figure", figure.number());
            fields.put("agrees", verdict.agrees().orElse(null));
            fields.put("measured", verdict.measured());
            fields.put("missing", verdict.missing());
            verdicts.add(fields);
            own.forEach(drawing -> numbers.addAll(drawing.numbers()));
        });
        numbers.forEach(row ->
                json.text(out()).println(Text.format("%s, %s: thesis %s, here %s, difference %s", row.toArray())));
        json.print(out(), new TreeMap<>(Map.of("verdicts", verdicts, "table", numbers)), List.of(output.resolve(PAGE)));
        return code;
    }

    private String source(String patch) {
        if (patchFolder == null) {
            return BUILT_IN.get(patch);
        }
        Path descriptor = patchFolder.resolve(patch + ".json");
        if (!Files.isRegularFile(descriptor)) {
            throw new UsageException("--patches " + patchFolder + ": there is no " + patch
                    + ".json; give a folder with blaze.json, elaphe.json and xenopeltis.json");
        }
        return descriptor.toString();
    }

    /** Returns the exit code of the first command that failed. */
    private int draw(Map<Figure, List<Figure.Drawing>> drawings) {
        int code = ExitCode.OK.code();
        List<Figure.Drawing> all =
                drawings.values().stream().flatMap(List::stream).toList();
        try (Progress progress = display.start("Figures", all.size())) {
            for (Figure.Drawing drawing : all) {
                int result = draw(drawing, drawings.get(drawing.figure()));
                if (result == ExitCode.INTERRUPTED.code()) {
                    return result;
                }
                code = code == ExitCode.OK.code() ? result : code;
                progress.step(1);
            }
        }
        return code;
    }

    private int draw(Figure.Drawing drawing, List<Figure.Drawing> own) {
        boolean replaced = overwrite() == Overwrite.REPLACE;
        if (drawing.picture().plot() != null) {
            drawing.picture().plot().draw(drawing, own);
            return ExitCode.OK.code();
        }
        drawing.writeInput(output);
        if (!drawing.resumes() && !replaced && Files.exists(drawing.file())) {
            return ExitCode.OK.code();
        }
        List<String> words = new ArrayList<>(drawing.command());
        if (drawing.resumes()) {
            words.add("--resume");
        }
        if (replaced) {
            words.add("--force");
        }
        Collection.Outcome outcome = runner.apply(words);
        if (outcome.isWritten()) {
            return ExitCode.OK.code();
        }
        if (outcome.code() != ExitCode.INTERRUPTED.code()) {
            err().println(Messages.error("figure " + drawing.file().getFileName() + ": " + outcome.message()));
        }
        return outcome.code();
    }

    /** Returns the text by which a page is known as one of the same figures, sizes and patches, which a further run continues. */
    private String options(Map<Figure, List<Figure.Drawing>> drawings, Figure.Sizes sizes) {
        String numbers = drawings.keySet().stream().map(Figure::number).collect(Collectors.joining(","));
        String patches = patchFolder == null ? "built-in patches" : patchFolder.toString();
        return escape("Sunbeam figures " + numbers + " of " + patches + ", " + sizes);
    }

    private void checkPage(String options) {
        Path page = output.resolve(PAGE);
        AtomicFile.checkWritable(page, Overwrite.REPLACE);
        try {
            if (overwrite() == Overwrite.REFUSE
                    && Files.exists(page)
                    && !Files.readString(page).contains("content=\"" + options + "\">\n")) {
                throw new OutputException.Exists(
                        "cannot write " + page
                                + ": it exists and is no page of these figures and options; add --force to replace it, or choose another --output");
            }
        } catch (IOException failure) {
            throw OutputException.of(page, failure);
        }
    }

    private String page(Map<Figure, List<Figure.Drawing>> drawings, String options) {
        StringBuilder html =
                new StringBuilder(quick ? "<p>Drawn with --quick: small pictures, coarse responses.</p>\n" : "");
        drawings.forEach((figure, own) -> {
            String check = figure.verdict(own).toString();
            html.append("<h2>").append(escape(figure.heading())).append("</h2>\n<p><b>Thesis:</b> ");
            html.append(escape(figure.thesis())).append("<br><b>Here:</b> ").append(escape(figure.ours()));
            html.append("<br><b>Check:</b> ").append(escape(check)).append("</p>\n");
            html.append(table(own));
            for (String patch : figure.rows()) {
                html.append("<div class=\"row\">\n");
                own.stream()
                        .filter(drawing -> drawing.patch().equals(patch)
                                && !drawing.picture().hidden()
                                && Files.isRegularFile(drawing.file()))
                        .forEach(drawing -> html.append(picture(drawing)));
                html.append("</div>\n");
            }
        });
        return Environment.resource(FiguresCommand.class, "page.html")
                .replace("@OPTIONS@", options)
                .replace("@VERSION@", Environment.version())
                .replace("@FIGURES@", html);
    }

    private static String table(List<Figure.Drawing> drawings) {
        String head = "<table><tr><th>patch</th><th></th><th>thesis</th><th>here</th><th>difference</th></tr>\n";
        String rows = drawings.stream()
                .flatMap(drawing -> drawing.numbers().stream())
                .map(row -> row.stream().map(FiguresCommand::escape).collect(Collectors.joining("</td><td>")))
                .map(cells -> "<tr><td>" + cells + "</td></tr>\n")
                .collect(Collectors.joining());
        return rows.isEmpty() ? "" : head + rows + "</table>\n";
    }

    private String picture(Figure.Drawing drawing) {
        String kind = drawing.command().contains("--no-annotate") ? " class=\"map\"" : "";
        String file = escape(output.relativize(drawing.file()).toString().replace('\\', '/'));
        String label = (drawing.patch().isEmpty() ? "" : drawing.patch() + ": ")
                + drawing.picture().label();
        String difference = drawing.base()
                .filter(Files::isRegularFile)
                .map(base -> "; " + Measure.difference(drawing.file(), base).text() + " from the first")
                .orElse("");
        String command =
                drawing.command().isEmpty() ? "" : "./sunbeam " + String.join(" ", drawing.command()) + " --force";
        return "<figure" + kind + "><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + escape(label)
                + "\"></a><figcaption>" + escape(label + difference) + "<br><code>"
                + escape(command) + "</code></figcaption></figure>\n";
    }

    private static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
