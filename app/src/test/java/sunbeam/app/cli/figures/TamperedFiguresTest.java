package sunbeam.app.cli.figures;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntUnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.app.cli.CommandLineFixture;
import sunbeam.app.cli.program.Sunbeam;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.terminal.Environment;

/** Each figure's rules refuse a set of surfaces that the thesis does not have: flat ones, white noise, or the skins exchanged. */
class TamperedFiguresTest extends CommandLineFixture {
    // A scene of this size shows the snake in some hundred pixels.
    private static final Figure.Sizes SMALL = new Figure.Sizes(40, "48x36", "400:700:50");
    private static final int SIDE = 128;

    /** Folder of the cache, which keeps the snake's texture from one figure to the next. */
    @TempDir
    static Path home;

    private enum Tampering {
        FLAT,
        NOISE,
        EXCHANGED
    }

    private Path grays(String name, int side, IntUnaryOperator gray) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_BYTE_GRAY);
        for (int i = 0; i < side * side; i++) {
            image.getRaster().setSample(i % side, i / side, 0, gray.applyAsInt(i));
        }
        return PngWriter.write(folder.resolve(name), Overwrite.REPLACE, image, Map.of());
    }

    private IntUnaryOperator gray(Tampering tampering) {
        Random random = new Random(1);
        return i -> tampering == Tampering.FLAT ? 128 : random.nextInt(256);
    }

    private String source(String patch, Tampering tampering) {
        if (tampering == Tampering.EXCHANGED) {
            return Map.of("blaze", "blaze", "elaphe", "xenopeltis-like", "xenopeltis", "elaphe-like")
                    .get(patch);
        }
        String size = Map.of(
                        "blaze", "\"width\": \"2.5 um\", \"maxHeight\": \"250 nm\"",
                        "elaphe", "\"width\": \"65 um\", \"maxHeight\": \"375 nm\"",
                        "xenopeltis", "\"width\": \"65 um\", \"maxHeight\": \"819 nm\"")
                .get(patch);
        grays(patch + "-heights.png", SIDE, gray(tampering));
        try {
            return Files.writeString(
                            folder.resolve(patch + ".json"),
                            "{\"heights\": \"" + patch + "-heights.png\", " + size + "}")
                    .toString();
        } catch (IOException failure) {
            throw new IllegalStateException(failure);
        }
    }

    private void run(Figure.Drawing drawing, Tampering tampering) {
        drawing.writeInput(folder);
        if (String.join(" ", drawing.command()).contains("slits.png")) {
            grays("slits.png", 50, gray(tampering));
        }
        forgetOutput();
        Environment environment = new Environment(Map.of(), home);
        String[] words = drawing.command().toArray(String[]::new);
        new Sunbeam(environment, new PrintWriter(out), new PrintWriter(err)).run(words);
        assertThat(drawing.file()).as("%s", err).exists();
    }

    /** Draws the first map of a patch, whose exposure the others use, and the named pictures of a figure; returns its verdict. */
    private Check.Verdict verdict(Figure figure, Tampering tampering, List<String> names) {
        List<Figure.Drawing> all = figure.drawings(patch -> source(patch, tampering), SMALL, folder);
        for (Figure.Drawing drawing : all) {
            boolean isBase = all.stream()
                    .filter(other -> names.contains(other.name()))
                    .anyMatch(other -> other.base().equals(Optional.of(drawing.file())));
            if (isBase || names.contains(drawing.name())) {
                run(drawing, tampering);
            }
        }
        return figure.verdict(all);
    }

    /** The pictures are those that a failing rule needs: other numbers are missing, and the rule decides nevertheless. */
    @ParameterizedTest
    @CsvSource({
        "3.1, FLAT, powers",
        "4.5, FLAT, 7",
        "4.6, FLAT, middle",
        "4.9, EXCHANGED, c",
        "table-4.1, EXCHANGED, elaphe",
        "4.10, EXCHANGED, elaphe-nmm",
        "4.11, EXCHANGED, elaphe-ring",
        "5.2, EXCHANGED, xenopeltis elaphe",
        "5.3, FLAT, blaze-full",
        "5.4, FLAT, blaze-full",
        "5.5, NOISE, blaze-10nm",
        "5.6, FLAT, elaphe-10nm",
        "5.7, FLAT, blaze-full",
        "5.8, NOISE, elaphe-full elaphe-ring",
        "5.9, NOISE, xenopeltis-full-0 xenopeltis-ring-0",
        "5.10, FLAT, blaze-3.25um blaze-6.5um",
        "5.11, FLAT, blaze-6",
        "5.12, FLAT, elaphe-7",
        "5.13, FLAT, xenopeltis-0 xenopeltis-20",
        "5.14, FLAT, a b",
        "5.15, FLAT, texture body",
        "5.16, FLAT, texture body",
        "5.17, FLAT, 16.5 0.52",
        "5.18, NOISE, alone-0 alone-2"
    })
    void aFigureOfOtherSurfacesDiffers(String number, Tampering tampering, String pictures) {
        Figure figure = Figure.select(List.of(number)).get(0);

        Check.Verdict verdict = verdict(figure, tampering, List.of(pictures.split(" ", -1)));

        assertThat(verdict.agrees()).as("%s", verdict).contains(false);
    }

    /** Only 2.6, 2.8 and 2.11 draw no surface: their plots are of formulas. */
    @Test
    void everyFigureOfASurfaceIsAbove() throws NoSuchMethodException {
        List<String> tested = Stream.of(getClass()
                        .getDeclaredMethod("aFigureOfOtherSurfacesDiffers", String.class, Tampering.class, String.class)
                        .getAnnotation(CsvSource.class)
                        .value())
                .map(row -> row.split(",", -1)[0])
                .toList();
        assertThat(Figure.all())
                .extracting(Figure::number)
                .filteredOn(number -> !List.of("2.6", "2.8", "2.11").contains(number))
                .containsExactlyElementsOf(tested);
    }
}
