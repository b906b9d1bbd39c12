package sunbeam.app.cli;

import java.io.File;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import sunbeam.app.files.input.PngText;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.patch.Patch;

/**
 * Option {@code --resume} of commands that write a picture and perhaps a linear file with it; a picocli mixin. The picture's text entries
 * hold the exit code and a hash of the version, the surfaces, the options and the files that these name.
 */
public final class ResumeOption {
    private static final String EXIT_CODE = "Exit code";
    private static final String LINEAR_HASH = "Linear file";
    /** Options that do not change the picture's pixels and so do not enter the hash. */
    private static final Set<String> IGNORED =
            Set.of(("--resume --json --force --explain --output --linear --tev --quiet --debug"
                            + " --help --help-all --version")
                    .split(" ", -1));

    private static final int BLOCK_BYTES = 1 << 16;
    /** Bytes of a file that are hashed, a second's work; a longer one is known by its size and time besides. */
    private static final long MOST_HASHED = 1L << 28;

    @Option(
            names = "--resume",
            description = "Keep existing files that were made of the same surface with the same options,"
                    + " and draw the others.")
    private boolean resume;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /** Refuses the option for a command that keeps the files of several surfaces only. */
    public void requireMany() {
        UsageException.throwIf(resume, "--resume is for several patches or a folder; leave it out for one");
    }

    public boolean isGiven() {
        return resume;
    }

    /** Returns a SHA-256 hash, in hexadecimal, of everything that determines the output. */
    public String identity(List<Patch> patches) {
        List<String> words = new ArrayList<>(List.of(command.qualifiedName()));
        patches.forEach(patch -> words.add("|" + patch.heights().digest()));
        for (OptionSpec option : command.options()) {
            boolean isDefault = option.originalStringValues().isEmpty() && option.defaultValue() != null;
            (isDefault ? List.of(option.defaultValue()) : option.originalStringValues())
                    .forEach(value -> words.add(option.longestName() + "=" + value));
        }
        return hash(words);
    }

    /**
     * Returns a SHA-256 hash of the version, of options as {@code --name=value} that change the output, and of the files they name; throws
     * InputException if one cannot be read.
     */
    public static String hash(List<String> words) {
        Sha256 hash = new Sha256().add(Environment.version());
        for (String word : words) {
            String[] option = word.split("=", 2);
            if (!IGNORED.contains(option[0])) {
                addFile(hash.add("|" + word), option[option.length - 1]);
            }
        }
        return hash.hex();
    }

    /** Adds the content of a file; nothing if the text names none. Files of the kernel have no size and may never end: none is read. */
    private static Sha256 addFile(Sha256 hash, String name) {
        File file = new File(name);
        if (!file.isFile()) {
            return hash;
        }
        long rest = Math.min(file.length(), MOST_HASHED);
        if (file.length() > rest) {
            hash.add(file.length() + "@" + file.lastModified());
        }
        byte[] block = new byte[BLOCK_BYTES];
        try (InputStream stream = new FileInputStream(file)) {
            int count = 1;
            while (rest > 0 && count > 0) {
                count = stream.read(block, 0, (int) Math.min(block.length, rest));
                hash.add(ByteBuffer.wrap(block, 0, Math.max(0, count)));
                rest -= count;
            }
            return hash;
        } catch (IOException failure) {
            throw InputException.of(file.toPath(), failure);
        }
    }

    public static void noteLinear(Map<String, String> text, Path file) {
        text.put(LINEAR_HASH, addFile(new Sha256(), file.toString()).hex());
    }

    /** Adds to a picture's text the entries that {@link #finished} reads. */
    public static void note(Map<String, String> text, String identity, ExitCode code) {
        text.put(PngText.PARAMETERS, identity);
        text.put(EXIT_CODE, Integer.toString(code.code()));
    }

    /** Returns the exit code of the earlier run that wrote these files, the second of which may be null, with the same options. */
    public Optional<Integer> finished(String identity, Path picture, Path linear, PrintWriter err) {
        if (!resume) {
            return Optional.empty();
        }
        Optional<Integer> code = PngText.find(picture, identity)
                .filter(text -> linear == null
                        || addFile(new Sha256(), linear.toString()).hex().equals(text.get(LINEAR_HASH)))
                .map(text -> text.getOrDefault(EXIT_CODE, ""))
                .filter(number -> number.matches("\\d{1,3}"))
                .map(Integer::valueOf);
        code.ifPresent(kept -> err.println(Messages.note(picture + " was made with the same options: kept")));
        return code;
    }
}
