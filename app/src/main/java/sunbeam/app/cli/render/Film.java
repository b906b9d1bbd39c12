package sunbeam.app.cli.render;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;

/** Format of a film of an animation's frames, which the program ffmpeg writes. */
enum Film {
    /** H.264, which takes even sides: an odd one gets a black row or column. */
    MP4("-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf", "16", "-movflags", "+faststart"),
    WEBP("-quality", "90", "-loop", "0"),
    /** Without loss. */
    APNG("-plays", "0");

    private static final String PROGRAM = "ffmpeg";

    @SuppressWarnings("ImmutableEnumChecker") // an unmodifiable list
    private final List<String> options;

    Film(String... options) {
        this.options = List.of(options);
    }

    @Override
    public String toString() {
        return ValueKind.name(this);
    }

    Path in(Path folder) {
        return folder.resolve("animation." + this);
    }

    /** Throws {@link UsageException} unless the program can be started. */
    void requireProgram() {
        try {
            run(new ProcessBuilder(PROGRAM, "-version"));
        } catch (IOException missing) {
            throw new UsageException("--film " + this + " needs the program " + PROGRAM
                    + ", which cannot be started; install it (Debian: apt install ffmpeg), or leave --film out");
        }
    }

    /** Writes a film of a folder's {@code frame-0001.png} and so on; throws {@link OutputException} if the program fails. */
    void write(Path target, Overwrite overwrite, Path folder, int frames, double framesPerSecond) {
        try {
            Path made = Files.createTempFile("sunbeam-", "." + this);
            try {
                List<String> command = new ArrayList<>(List.of(PROGRAM, "-nostdin", "-y", "-loglevel", "error"));
                command.addAll(List.of("-framerate", Text.format("%.6f", framesPerSecond), "-i", "frame-%04d.png"));
                command.addAll(List.of("-frames:v", Integer.toString(frames)));
                command.addAll(options);
                command.add(made.toString());
                // The folder's own name may have percent signs.
                String complaint = run(new ProcessBuilder(command).directory(folder.toFile()));
                if (!complaint.isEmpty()) {
                    throw new OutputException("cannot write " + target + ": " + PROGRAM + " says " + complaint
                            + "; the frames are written, use --resume");
                }
                AtomicFile.write(target, overwrite, stream -> Files.copy(made, stream));
            } finally {
                Files.deleteIfExists(made);
            }
        } catch (IOException failure) {
            throw OutputException.of(target, failure);
        }
    }

    /** Returns what the program complains about in one line; empty if it succeeds. */
    private static String run(ProcessBuilder program) throws IOException {
        Process process = program.redirectErrorStream(true).start();
        try {
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return process.waitFor() == 0 ? "" : Text.oneLine("\"" + said.strip() + "\"");
        } catch (InterruptedException ending) {
            process.destroy();
            Thread.currentThread().interrupt();
            return "that it was interrupted";
        }
    }
}
