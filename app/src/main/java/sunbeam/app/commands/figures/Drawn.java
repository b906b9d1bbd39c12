package sunbeam.app.commands.figures;

import java.util.Objects;

/**
 * A picture that the folder has.
 *
 * @param version of the program that drew it
 * @param command that drew it
 * @param caption what came of it
 */
record Drawn(String version, String command, String caption) {
    Drawn {
        version = Objects.requireNonNullElse(version, "");
        command = Objects.requireNonNullElse(command, "");
        caption = Objects.requireNonNullElse(caption, "");
    }
}
