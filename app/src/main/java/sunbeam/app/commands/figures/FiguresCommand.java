package sunbeam.app.commands.figures;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.commands.evaluate.NoPeriodException;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.ForceOption;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputExistsException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;

/** {@code sunbeam figures}: the thesis's result figures as one folder. */
@Command(
        name = "figures",
        header = "Draw the thesis's result figures as one folder with a page.",
        description = "Draw the result figures of the thesis as one folder: BRDF maps per patch (5.3), method (5.4),"
                + " wavelength step (5.5, 5.6), full against pq (5.7 to 5.9), per coherence window (5.10), number of"
                + " terms (5.11, 5.12) and angle of incidence (5.13); the evaluation by the grating equation (4.9 to"
                + " 4.11) with Table 4.1. Pictures that are there already are kept, so that a run which was stopped"
                + " goes on where it ended. Look at index.html.")
public final class FiguresCommand implements Callable<Integer> {
    private static final int LARGEST = 2048;
    private static final String PAGE = "index.html";

    private final Environment environment;

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
            description = "Only these figures, for example 5.10 or 5.3,5.4. The page shows all that the folder has.")
    private List<String> only = new ArrayList<>();

    @Option(
            names = "--size",
            paramLabel = "PIXELS",
            defaultValue = "256",
            description = "Width and height of each map within its margins, 16 to 2048. Default: ${DEFAULT-VALUE}.")
    private int size;

    @Option(
            names = "--patches",
            paramLabel = "FOLDER",
            description = "Folder with the measured patches blaze.json, elaphe.json and xenopeltis.json. Default: the"
                    + " built-in patches blaze, elaphe-like and xenopeltis-like.")
    private Path patchFolder;

    @Mixin
    private ForceOption force;

    @Spec
    private CommandSpec specification;

    public FiguresCommand(Environment environment) {
        this.environment = environment;
    }

    @Override
    public Integer call() {
        if (size < 16 || size > LARGEST) {
            throw new UsageException("--size " + size + " is out of range; give 16 to " + LARGEST);
        }
        List<Figure> wanted = Catalogue.select(only);
        PrintWriter err = specification.commandLine().getErr();
        Overwrite overwrite = force.overwrite();
        FigurePatches patches = new FigurePatches(patchFolder, environment, err);
        OutputFolder.create(output);
        checkPage(overwrite);
        PanelStore store = new PanelStore(output, size, overwrite, patches);
        List<Panel> missing = wanted.stream()
                .flatMap(figure -> figure.panels().stream())
                .filter(panel -> store.finished(panel).isEmpty())
                .toList();
        missing.forEach(store::requireFree);
        Journal journal = new Journal(err, missing.size());
        List<String> failures = draw(missing, patches, store, journal);
        writePage(store);
        PrintWriter out = specification.commandLine().getOut();
        failures.forEach(err::println);
        out.println(output.resolve(PAGE));
        return failures.isEmpty() ? ExitCode.OK.code() : ExitCode.UNUSABLE_INPUT.code();
    }

    /** A page that another program wrote stays. */
    private void checkPage(Overwrite overwrite) {
        Path page = output.resolve(PAGE);
        AtomicFile.checkWritable(page, Overwrite.REPLACE);
        try {
            if (overwrite == Overwrite.REFUSE
                    && Files.exists(page)
                    && !Files.readString(page).contains(FiguresPage.GENERATOR)) {
                throw new OutputExistsException(
                        "cannot write " + page
                                + ": it exists and is no page of figures; add --force to replace it, or choose another --output");
            }
        } catch (IOException failure) {
            throw OutputException.of(page, failure);
        }
    }

    /** Draws maps first, then responses, which open a context of their own. */
    private List<String> draw(List<Panel> missing, FigurePatches patches, PanelStore store, Journal journal) {
        List<String> failures = new ArrayList<>();
        if (missing.stream().anyMatch(Panel.MapPanel.class::isInstance)) {
            try (MapDrawer maps = new MapDrawer(patches, store, size)) {
                for (Panel panel : missing) {
                    if (panel instanceof Panel.MapPanel map) {
                        maps.draw(map);
                        journal.finished(panel);
                    }
                }
            }
        }
        ResponseDrawer responses = new ResponseDrawer(patches, store);
        for (Panel panel : missing) {
            if (panel instanceof Panel.ResponsePanel response) {
                try {
                    responses.draw(response);
                } catch (NoPeriodException none) {
                    failures.add("sunbeam: figure " + panel.name() + ": " + none.getMessage());
                }
                journal.finished(panel);
            }
        }
        return failures;
    }

    /** Page and table of all figures that the folder has with these patches and this size. */
    private void writePage(PanelStore store) {
        List<Figure> all = Catalogue.all();
        Map<Panel, Map<String, String>> texts = new LinkedHashMap<>();
        for (Figure figure : all) {
            for (Panel panel : figure.panels()) {
                Optional<Map<String, String>> text = store.finished(panel);
                text.ifPresent(found -> texts.put(panel, found));
            }
        }
        write(PAGE, FiguresPage.of(all, texts));
        List<String> table = FiguresPage.tableLines(all, texts);
        if (!table.isEmpty()) {
            write("table-4.1.csv", String.join("\n", table) + "\n");
        }
    }

    private void write(String name, String content) {
        AtomicFile.write(
                output.resolve(name),
                Overwrite.REPLACE,
                stream -> stream.write(content.getBytes(StandardCharsets.UTF_8)));
    }
}
