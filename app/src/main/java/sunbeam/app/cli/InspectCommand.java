package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;

/** Command {@code sunbeam inspect}: reports the properties of a patch's heights, without computing colors. */
@Command(
        name = "inspect",
        header = "Look at a height map: verdict, relief, slopes, period.",
        description = "Look at a patch before rendering it: first what it is in one sentence, then size, relief,"
                + " roughness, slopes and its period; as text and as one picture with histogram and power spectrum.",
        footer = {
            "  sunbeam inspect scan.gwy",
            "  sunbeam inspect folder --output report",
            "  sunbeam inspect scan.png --width 65um --max-height 375nm"
        })
public final class InspectCommand extends FileCommand {
    @Mixin
    private final PatchOptions patchOptions = PatchOptions.ofMany();

    @Mixin
    private final SettingOptions light = new SettingOptions(List.of(LightOptions.THETA_I));

    @Mixin
    private ResumeOption resume;

    @Mixin
    private PageOptions page;

    @Option(
            names = "--panel",
            paramLabel = "NAME",
            description =
                    "Draw one panel alone, and write its values beside it (.csv): ${COMPLETION-CANDIDATES}; those of"
                            + " HEIGHTS are the scan's.")
    private InspectionSheet.Panel panel;

    @Option(
            names = "--output",
            paramLabel = "FILE",
            description =
                    "The picture (.png, .pdf or .svg), or the folder of several. Default: a name made of the patch.")
    private Path output;

    @Option(
            names = "--explain",
            description =
                    "Say more: source, channels, faults, warnings in full, the model's error, the plan and its cost.")
    private boolean explain;

    /** Returns the picture that the command writes without options, of a patch whose period is known. */
    public static Drawing picture(Patch patch, GratingPeriod period) {
        Inspection inspection = Inspection.of(patch, period, 0, false);
        return new InspectionSheet(inspection, inspection.lines(), Drawing.COLUMN, Optional.empty()).draw();
    }

    @Override
    public Integer call() {
        resume.requireMany();
        Ending.PICTURE.require("--output", output);
        page.width();
        PrintWriter out = out(output);
        AtomicFile.checkWritable(output, overwrite());
        Patch loaded = patchOptions.load(Choices.none());
        Messages.printScan(loaded, loaded.warnings(), explain, err());
        Path picture = writable(
                output, "inspect-" + loaded.name() + (panel == null ? "" : "-" + ValueKind.name(panel)) + ".png");
        double theta = Math.rint(1e9 * Math.toDegrees(light.choices().get(LightOptions.THETA_I))) / 1e9;
        Inspection inspection = Inspection.of(loaded, cachedPeriod(loaded), theta, explain || json.isGiven());
        List<String> lines = new ArrayList<>(inspection.lines());
        if (explain) {
            lines.addAll(inspection.explanation());
        }
        lines.forEach(json.text(out)::println);
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "Inspection of " + loaded.name());
        text.put("Patch", loaded.source());
        text.put("Verdict", inspection.verdict().sentence());
        // Also --json makes the plan, but writes the same picture as without it.
        inspection.plan().filter(summary -> explain).ifPresent(summary -> text.put("Plan", summary));
        InspectionSheet sheet = new InspectionSheet(inspection, lines, page.pixels(), Optional.ofNullable(panel));
        List<Path> places = write(picture, overwrite(output), sheet.draw(), page.width(), text, sheet.csv());
        Map<String, Object> fields = inspection.fields();
        fields.put("thumbnail_px", sheet.thumbnail());
        json.print(out, fields, places);
        return doubt(List.of(loaded)).code();
    }
}
