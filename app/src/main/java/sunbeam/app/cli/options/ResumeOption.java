package sunbeam.app.cli.options;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
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
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.UsageException;
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

    /** Returns the rule for existing files before the surfaces and thus the hash are known: with {@code --resume} they may exist. */
    public Overwrite beforeLoading(Overwrite overwrite) {
        return resume ? Overwrite.REPLACE : overwrite;
    }

    /** Returns the name to treat as the user's: with {@code --resume} also a chosen one, so that a file is replaced, not numbered. */
    public Path named(Path byUser, Path chosen) {
        return resume ? chosen : byUser;
    }

    /** Returns a SHA-256 hash, in hexadecimal, of everything that determines the output. */
    public String identity(List<Patch> patches) {
        List<String> words = new ArrayList<>(List.of(command.qualifiedName()));
        patches.forEach(patch -> words.add("|" + patch.digest()));
        for (OptionSpec option : command.options()) {
            boolean isDefault = option.originalStringValues().isEmpty() && option.defaultValue() != null;
            (isDefault ? List.of(option.defaultValue()) : option.originalStringValues())
                    .forEach(value -> words.add(option.longestName() + "=" + value));
        }
        return hash(words);
    }

    /** Returns a SHA-256 hash of the version, of options as {@code --name=value} that change the output, and of the files they name. */
    public static String hash(List<String> words) {
        Sha256 hash = new Sha256().add(Environment.version());
        for (String word : words) {
            String[] option = word.split("=", 2);
            if (!IGNORED.contains(option[0])) {
                hash.add("|" + word);
                try {
                    addFile(hash, Path.of(option[option.length - 1]));
                } catch (InvalidPathException noFile) {
                    // The value is no path.
                }
            }
        }
        return hash.hex();
    }

    private static Sha256 addFile(Sha256 hash, Path file) {
        if (!Files.isRegularFile(file)) {
            return hash;
        }
        try (InputStream stream = Files.newInputStream(file)) {
            for (byte[] block = stream.readNBytes(BLOCK_BYTES);
                    block.length > 0;
                    block = stream.readNBytes(BLOCK_BYTES)) {
                hash.add(block);
            }
            return hash;
        } catch (IOException failure) {
            // The command has read this file before, so a failure here is no mistake of the user.
            throw new UncheckedIOException(file.toString(), failure);
        }
    }

    public static void noteLinear(Map<String, String> text, Path file) {
        text.put(LINEAR_HASH, addFile(new Sha256(), file).hex());
    }

    /** Adds to a picture's text the entries that {@link #finished} reads. */
    public static void note(Map<String, String> text, String identity, ExitCode code) {
        text.put(PngText.PARAMETERS, identity);
        text.put(EXIT_CODE, Integer.toString(code.code()));
    }

    /** Returns the exit code of the earlier run that wrote these files with the same options; empty without {@code --resume}. */
    public Optional<Integer> finished(String identity, Path picture, Optional<Path> linear, PrintWriter err) {
        if (!resume) {
            return Optional.empty();
        }
        Optional<Integer> code = PngText.find(picture, identity)
                .filter(text -> linear.isEmpty()
                        || addFile(new Sha256(), linear.get()).hex().equals(text.get(LINEAR_HASH)))
                .map(text -> text.getOrDefault(EXIT_CODE, ""))
                .filter(number -> number.matches("\\d{1,3}"))
                .map(Integer::valueOf);
        code.ifPresent(kept -> {
            err.println(Messages.note(picture + " was made with the same options: kept"));
            err.flush();
        });
        return code;
    }
}
