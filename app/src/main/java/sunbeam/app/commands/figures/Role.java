package sunbeam.app.commands.figures;

import java.util.Locale;

/** The part that a patch plays in the thesis's figures. */
enum Role {
    BLAZE("blaze"),
    ELAPHE("elaphe-like"),
    XENOPELTIS("xenopeltis-like");

    private final String builtIn;

    Role(String builtIn) {
        this.builtIn = builtIn;
    }

    /** The built-in patch that plays it where no measured one is given. */
    String builtIn() {
        return builtIn;
    }

    /** Name in files: {@code blaze.json} is the descriptor of the measured patch. */
    String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
