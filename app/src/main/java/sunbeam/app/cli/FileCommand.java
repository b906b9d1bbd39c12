package sunbeam.app.cli;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.cache.BlobCache;
import sunbeam.app.files.cache.PeriodCache;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Ending;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Drawing;
import sunbeam.app.files.plot.PictureFile;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.patch.Patch;

/** Base class of commands that write files and report them: options {@code --force} and {@code --json}. */
public abstract class FileCommand extends ReportingCommand {
    // A smaller picture may lie between a grating's orders.
    private static final int FEWEST_PIXELS = 32;

    @Mixin
    protected final JsonOption json = new JsonOption();

    @Option(
            names = "--force",
            description = "Overwrite output files that exist. Without it a file that you name is never overwritten,"
                    + " and a name that Sunbeam chooses gets a number (-2, -3, ...) where it is taken.")
    private boolean force;

    /** Returns the rule for an existing file that the user named. */
    protected final Overwrite overwrite() {
        return force ? Overwrite.REPLACE : Overwrite.REFUSE;
    }

    /** Returns the rule for an existing output file of a name given by the user, or null if Sunbeam chooses it. */
    protected final Overwrite overwrite(Path named) {
        return force || named != null ? overwrite() : Overwrite.NUMBER;
    }

    /** Returns the output of a name that the user gave, else of the chosen one; throws an exception if it cannot be written. */
    protected final Path writable(Path named, String chosen) {
        Path target = named != null ? named : Path.of(chosen);
        AtomicFile.checkWritable(target, overwrite(named));
        return target;
    }

    /** Returns the picture, report and table of a name that the user gave, else of the chosen one, as {@link #writable} does. */
    protected final FileGroup writableGroup(Path named, String chosen) {
        Path name = named != null ? named : Path.of(chosen);
        FileGroup files =
                FileGroup.named(name, List.of("." + Ending.ofPicture(name), ".json", ".csv"), overwrite(named));
        files.checkWritable();
        return files;
    }

    /** Writes a report as table, JSON and picture, whose ending is the group's first, and prints their names or the report. */
    protected final void write(
            FileGroup files,
            Map<String, Object> report,
            StreamContent csv,
            Drawing picture,
            double width,
            Map<String, String> text) {
        Map<String, StreamContent> contents = new LinkedHashMap<>();
        contents.put(".csv", csv);
        contents.put(".json", StreamContent.of(JsonOption.text(json.withCommand(report))));
        Path named = Path.of(files.stem() + files.endings().get(0));
        contents.put(files.endings().get(0), PictureFile.of(named, picture, width, text));
        json.print(out(), report, files.write(contents));
    }

    /** Writes a picture and, if given, its values beside it with the ending .csv: both or none. Returns their paths. */
    protected static List<Path> write(
            Path picture,
            Overwrite overwrite,
            Drawing drawing,
            double width,
            Map<String, String> text,
            Optional<StreamContent> csv) {
        StreamContent content = PictureFile.of(picture, drawing, width, text);
        if (csv.isEmpty()) {
            return List.of(AtomicFile.write(picture, overwrite, content));
        }
        String ending = "." + Ending.of(picture);
        Map<String, StreamContent> contents = new LinkedHashMap<>(Map.of(ending, content));
        contents.put(".csv", csv.get());
        return FileGroup.named(picture, List.of(ending, ".csv"), overwrite).write(contents);
    }

    /** Returns the exit code of a picture that is written though it shows a mirror, of which loading has warned. */
    public static ExitCode doubt(List<Patch> patches) {
        return patches.stream().anyMatch(Patch::isMirror) ? ExitCode.TOLERANCE_MISSED : ExitCode.OK;
    }

    /** Warns if a picture, named such as "the map", is black; returns its exit code unless something else fails. */
    public static ExitCode doubt(
            List<Patch> patches, boolean black, String picture, boolean automatic, PrintWriter err) {
        if (!black) {
            return doubt(patches);
        }
        String remedy = automatic
                ? ", though its exposure was found from it: no light goes where it looks; move the light"
                : "; let the exposure be automatic, or raise it";
        err.println(Messages.warning(picture + " is black all over" + remedy));
        return ExitCode.TOLERANCE_MISSED;
    }

    /** Returns a patch's period, from the cache if it is there. */
    protected final GratingPeriod cachedPeriod(Patch patch) {
        return new PeriodCache(BlobCache.of(environment(), warning -> {})).of(patch);
    }

    /** True if all pixels are black; false for small pictures, which may be black by chance. */
    public static boolean isBlack(BufferedImage image) {
        int width = image.getWidth();
        return width >= FEWEST_PIXELS
                && IntStream.range(0, image.getHeight())
                        .mapToObj(y -> image.getRGB(0, y, width, 1, null, 0, width))
                        .flatMapToInt(Arrays::stream)
                        .allMatch(color -> (color & 0xffffff) == 0);
    }
}
