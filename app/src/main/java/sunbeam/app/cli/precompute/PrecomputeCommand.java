package sunbeam.app.cli.precompute;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.cli.options.FileCommand;
import sunbeam.app.cli.options.MethodOptions;
import sunbeam.app.cli.options.PatchOptions;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.plan.VisibleRange;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.spectrum.FourierTable;
import sunbeam.precompute.spectrum.TableFile;
import sunbeam.precompute.text.Text;

/** Command {@code sunbeam precompute}: writes the Fourier tables of a patch for other programs. */
@Command(
        name = "precompute",
        header = "Write the Fourier tables of a patch as HDF5.",
        description =
                "Write the Fourier tables of a patch to one HDF5 file: the DFT of every term T_n(h) of the expansion"
                        + " of exp(i k w h), complex float32, cropped to what any pair of directions can see. The file says what"
                        + " its numbers mean; see docs/conventions.md.",
        footer = {"  sunbeam precompute blaze --output blaze.h5"})
public final class PrecomputeCommand extends FileCommand {
    private static final int MOST_POWER = 99;

    @Mixin
    private PatchOptions patchOptions;

    @Mixin
    private final MethodOptions methodOptions = MethodOptions.of(FullMethod.TYPE);

    @Option(names = "--output", paramLabel = "FILE.h5", description = "The file. Default: the patch's name.")
    private Path output;

    @Option(
            names = "--picture",
            paramLabel = "FILE.png",
            description =
                    "Write no table, but draw the DFT of powers (i h)^n of the heights, in micrometers above the lowest: real"
                            + " parts red, imaginary parts green; and their extreme values over n.")
    private Path picture;

    @Option(
            names = "--powers",
            paramLabel = "N",
            split = ",",
            defaultValue = "0,1,4,10,20",
            description =
                    "Powers of --picture, 0 to 99, ascending. Of one alone there is no plot. Default: ${DEFAULT-VALUE}.")
    private List<Integer> powers;

    @Override
    public Integer call() {
        Ending.HDF5.require("--output", output);
        Choices choices = methodOptions.choices();
        return choices.located(() -> picture == null ? write(choices) : drawPowers(choices));
    }

    private int drawPowers(Choices choices) {
        Ending.PNG.require("--picture", picture);
        for (int i = 0; i < powers.size(); i++) {
            if (powers.get(i) < 0 || powers.get(i) > MOST_POWER || (i > 0 && powers.get(i) <= powers.get(i - 1))) {
                throw new UsageException(
                        "--powers " + powers.get(i) + ": give ascending numbers from 0 to " + MOST_POWER);
            }
        }
        AtomicFile.checkWritable(picture, overwrite());
        Patch patch = patchOptions.load(choices);
        FourierImages.Result drawn = new FourierImages(patch.heights()).draw(powers);
        Map<String, String> text = Map.of(
                "Title", "Fourier images of " + patch.name(),
                "Patch", patch.source(),
                "Extremes", Arrays.toString(drawn.largest()));
        Path written = PngWriter.write(picture, overwrite(), drawn.picture(), text);
        json.print(out(picture), Map.of("patch", patch.name(), "powers", powers), List.of(written));
        return ExitCode.OK.code();
    }

    private int write(Choices choices) {
        FullMethod.of(choices);
        AtomicFile.checkWritable(output, overwrite());
        DiffractionSetup setup =
                new DiffractionSetup(patchOptions.load(choices, environment(), err()), environment(), err());
        FullMethod method = FullMethod.of(setup.limitToScan(choices, err()));
        Path file = output != null ? output : Path.of(setup.patch().name() + ".h5");
        AtomicFile.checkWritable(file, overwrite(output));
        SpectrumPlan plan = method.tablePlan(setup.surface(), VisibleRange.all());
        methodOptions.explain(plan, err());
        long start = System.nanoTime();
        FourierTable table = setup.fourierTable(plan);
        double seconds = (System.nanoTime() - start) * 1e-9;
        Path written = AtomicFile.writeFile(
                file,
                overwrite(output),
                path -> TableFile.write(
                        path, table, setup.surface().name(), setup.surface().digest()));
        PrintWriter out = out(file);
        json.text(out)
                .println(Text.format(
                        "%d %s terms of %d x %d bins, %.1f MB, made in %.2f s",
                        table.terms(),
                        ValueKind.name(table.expansion().kind()),
                        table.bandX().count(),
                        table.bandY().count(),
                        table.bytes() * 1e-6,
                        seconds));
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("patch", setup.patch().name());
        report.put("kind", ValueKind.name(table.expansion().kind()));
        report.put("terms", table.terms());
        report.put("columns", table.bandX().count());
        report.put("rows", table.bandY().count());
        report.put("bytes", table.bytes());
        report.put("making_s", seconds);
        json.print(out, report, List.of(written));
        return ExitCode.OK.code();
    }
}
