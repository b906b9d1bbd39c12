package sunbeam.app.files.plot;

import java.awt.Font;
import java.awt.FontFormatException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Properties;

/**
 * Font of all pictures, which comes with the program (data/font), so that the same input gives the same picture on every machine. Letters
 * that it lacks, such as Chinese ones in a file's name, are from the system's fonts.
 */
public final class PlotFont {
    private static final Font PLAIN = load("Regular");
    private static final Font BOLD = load("Bold");

    private PlotFont() {}

    /** Sees to it that Java has fonts, before a window's first use of them; it does nothing but load this class. */
    public static void provide() {}

    /** Returns the font in a size in points of the picture's coordinates. */
    public static Font plain(float size) {
        return PLAIN.deriveFont(size);
    }

    public static Font bold(float size) {
        return BOLD.deriveFont(size);
    }

    /** Returns the font if it has all letters of a text, else the system's of the same size. */
    static Font with(Font font, String text) {
        return font.canDisplayUpTo(text) < 0
                ? font
                : new Font(Font.SANS_SERIF, font.isBold() ? Font.BOLD : Font.PLAIN, font.getSize());
    }

    /** Opens the TrueType file of a style, Regular or Bold. */
    static InputStream open(String style) {
        return PlotFont.class.getResourceAsStream("/sunbeam/font/SunbeamSans-" + style + ".ttf");
    }

    private static Font load(String style) {
        try {
            return read(style);
        } catch (InternalError | RuntimeException withoutFonts) {
            // Java's font manager does not start on a Linux without fontconfig or fonts, unless this names fonts.
            System.setProperty("sun.awt.fontconfig", configuration().toString());
            return read(style);
        }
    }

    private static Font read(String style) {
        try (InputStream file = open(style)) {
            Font font = Font.createFont(Font.TRUETYPE_FONT, file);
            return style.equals("Bold") ? font.deriveFont(Font.BOLD) : font;
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        } catch (FontFormatException broken) {
            throw new IllegalStateException(broken);
        }
    }

    /** Writes a font configuration file of Java in which all logical fonts are this one. */
    private static Path configuration() {
        try (InputStream font = open("Regular")) {
            Path copy = temporary(".ttf");
            Files.write(copy, font.readAllBytes());
            Properties properties = new Properties();
            properties.setProperty("version", "1");
            properties.setProperty("sequence.allfonts", "default");
            properties.setProperty("filename.Sunbeam", copy.toString());
            for (String family : new String[] {"serif", "sansserif", "monospaced", "dialog", "dialoginput"}) {
                for (String style : new String[] {"plain", "bold", "italic", "bolditalic"}) {
                    properties.setProperty(family + "." + style + ".default", "Sunbeam");
                }
            }
            Path configuration = temporary(".properties");
            try (Writer writer = Files.newBufferedWriter(configuration)) {
                properties.store(writer, null);
            }
            return configuration;
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    private static Path temporary(String ending) throws IOException {
        Path file = Files.createTempFile("sunbeam-font-", ending);
        file.toFile().deleteOnExit();
        return file;
    }
}
