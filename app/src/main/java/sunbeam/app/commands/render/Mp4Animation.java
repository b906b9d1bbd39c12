package sunbeam.app.commands.render;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.CancelledException;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ShutdownHook;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Quoted;

/** MP4 (H.264) by the program ffmpeg. */
final class Mp4Animation {
    private static final String PROGRAM = "ffmpeg";
    private static final String INPUT = "-nostdin -loglevel error -y -start_number 1";
    // Even sides, as 4:2:0 sampling needs them; colors by the standard of high definition, and said to be, so that
    // players do
    // not guess.
    private static final String ENCODING = "-vf pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv"
            + " -c:v libx264 -crf 18 -pix_fmt yuv420p -colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1"
            + " -color_range tv -f mp4";

    private Mp4Animation() {}

    /** @throws UsageException when ffmpeg is not on the path */
    static void requireProgram(Environment environment, Path target) {
        for (String folder : environment.variable("PATH").split(File.pathSeparator, -1)) {
            if (!folder.isEmpty() && Files.isExecutable(Path.of(folder).resolve(PROGRAM))) {
                return;
            }
        }
        throw new UsageException("--animation " + target
                + " needs the program ffmpeg, which is not on the PATH; install" + " it, or name a .gif file");
    }

    /** Encodes the frames, which are numbered from 1 in one folder. */
    static void write(Path target, Overwrite overwrite, List<Path> frames, double framesPerSecond) {
        Path pattern = frames.get(0).resolveSibling("frame-%04d.png");
        AtomicFile.writeFile(target, overwrite, file -> {
            List<String> words = new ArrayList<>(List.of(PROGRAM));
            words.addAll(List.of(INPUT.split(" ", -1)));
            words.addAll(List.of("-framerate", String.format(Locale.ROOT, "%.3f", framesPerSecond)));
            words.addAll(List.of("-i", pattern.toString(), "-frames:v", Integer.toString(frames.size())));
            words.addAll(List.of(ENCODING.split(" ", -1)));
            words.add(file.toString());
            ProcessBuilder builder = new ProcessBuilder(words);
            run(builder.redirectErrorStream(true), target);
        });
    }

    private static void run(ProcessBuilder builder, Path target) throws IOException {
        Process process = builder.start();
        ShutdownHook hook = new ShutdownHook(process::destroy);
        try {
            String words = new String(process.getInputStream().readNBytes(4096), StandardCharsets.UTF_8);
            process.getInputStream().transferTo(OutputStream.nullOutputStream());
            int status = process.waitFor();
            if (status != 0) {
                throw new OutputException("cannot write " + target + ": ffmpeg ended with " + status + " ("
                        + Quoted.oneLine(words.lines().findFirst().orElse("it said nothing"))
                        + "); the frames are complete, name a .gif file instead");
            }
        } catch (InterruptedException interrupted) {
            process.destroy();
            Thread.currentThread().interrupt();
            CancelledException cancelled = new CancelledException();
            cancelled.addSuppressed(interrupted);
            throw cancelled;
        } finally {
            hook.close();
        }
    }
}
