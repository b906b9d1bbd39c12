package sunbeam.app.files.output;

import java.nio.file.Path;

/** The names that an output may take which the user did not name: {@code blaze.png}, {@code blaze-2.png} and so on. */
final class NumberedNames {
    /** How many names are tried. */
    static final int MOST = 10_000;

    private final Path plain;
    private final String stem;
    private final String ending;

    private NumberedNames(Path plain, int stemLength) {
        String name = plain.getFileName().toString();
        this.plain = plain;
        this.stem = name.substring(0, stemLength);
        this.ending = name.substring(stemLength);
    }

    /** Of a file: what follows its last dot stays at the end. */
    static NumberedNames ofFile(Path plain) {
        String name = plain.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return new NumberedNames(plain, dot > 0 ? dot : name.length());
    }

    /** Of a folder: the number stands at the end. */
    static NumberedNames ofFolder(Path plain) {
        return new NumberedNames(plain, plain.getFileName().toString().length());
    }

    /** The name of a number from 1. */
    Path name(int number) {
        return number == 1 ? plain : plain.resolveSibling(stem + "-" + number + ending);
    }

    /** That there is none left. */
    OutputException exhausted() {
        return new OutputExistsException(
                "cannot write " + plain + ": " + MOST + " such files exist; name one with --output, or add --force");
    }
}
