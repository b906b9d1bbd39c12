package sunbeam.app.cli.inspect;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.options.FileCommand;
import sunbeam.app.cli.options.LightOptions;
import sunbeam.app.cli.options.PatchOptions;
import sunbeam.app.cli.options.ResumeOption;
import sunbeam.app.cli.options.SettingOptions;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StandardOutput;
import sunbeam.app.gpu.picture.DoubtfulPicture;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;

/** Command {@code sunbeam inspect}: reports the properties of a patch's heights, without computing colors. */
@Command(
        name = "inspect",
        header = "Look at a height map: verdict, relief, slopes, period.",
        description =
                "Look at a patch before rendering it: first what it is in one sentence, then size, relief, roughness,"
                        + " slopes and its period; as text and as one picture with histogram and power spectrum.",
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

    @Option(
            names = "--output",
            paramLabel = "FILE.png",
            description = "The picture, or the folder of several. Default: a name made of the patch.")
    private Path output;

    @Option(
            names = "--explain",
            description =
                    "Say more: source, channels, faults, warnings in full, the model's error, the plan and its cost.")
    private boolean explain;

    @Override
    public Integer call() {
        resume.requireMany();
        Ending.PNG.require("--output", output);
        if (json.isGiven() && StandardOutput.isMeant(output)) {
            throw new UsageException("--json and --output - both want standard output; name a file for the picture");
        }
        PrintWriter err = err();
        PrintWriter out = out(output);
        AtomicFile.checkWritable(output, overwrite());
        Patch loaded = patchOptions.load(Choices.none());
        Messages.printScan(loaded, loaded.warnings(), explain, err);
        Path picture = output != null ? output : Path.of("inspect-" + loaded.name() + ".png");
        AtomicFile.checkWritable(picture, overwrite(output));
        double theta = Math.toDegrees(light.choices().get(LightOptions.THETA_I));
        Inspection inspection = Inspection.of(loaded, theta, explain || json.isGiven());
        List<String> lines = new ArrayList<>(inspection.lines());
        if (explain) {
            lines.addAll(inspection.explanation());
        }
        lines.forEach(json.text(out)::println);
        Map<String, String> text = new LinkedHashMap<>();
        text.put("Title", "Inspection of " + loaded.name());
        text.put("Patch", loaded.source());
        text.put("Verdict", inspection.verdict().sentence());
        inspection.plan().ifPresent(summary -> text.put("Plan", summary));
        InspectionSheet sheet = new InspectionSheet(inspection, loaded.scan(), lines.subList(1, lines.size()));
        Path place = PngWriter.write(picture, overwrite(output), sheet.draw(), text);
        Map<String, Object> fields = inspection.fields();
        fields.put("thumbnail_px", sheet.thumbnail());
        json.print(out, fields, List.of(place));
        return DoubtfulPicture.ofPatches(List.of(loaded)).code();
    }
}
