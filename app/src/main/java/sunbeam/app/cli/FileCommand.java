package sunbeam.app.cli;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.AtomicFile.StreamContent;
import sunbeam.app.files.output.FileGroup;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;

/** Base class of commands that write files and report them: options {@code --force} and {@code --json}. */
public abstract class FileCommand extends ReportingCommand {
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
        FileGroup files = FileGroup.named(name, List.of(".png", ".json", ".csv"), overwrite(named));
        files.checkWritable();
        return files;
    }

    /** Writes a report as table, JSON and picture, whose ending is the group's first, and prints their names or the report. */
    protected final void write(
            FileGroup files,
            Map<String, Object> report,
            StreamContent csv,
            BufferedImage picture,
            Map<String, String> text) {
        Map<String, StreamContent> contents = new LinkedHashMap<>();
        contents.put(".csv", csv);
        contents.put(".json", StreamContent.of(JsonOption.text(report)));
        contents.put(files.endings().get(0), stream -> PngWriter.write(stream, picture, text));
        json.print(out(), report, files.write(contents));
    }
}
