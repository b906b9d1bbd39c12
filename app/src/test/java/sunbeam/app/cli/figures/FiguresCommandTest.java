package sunbeam.app.cli.figures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import sunbeam.app.cli.Collection;
import sunbeam.app.cli.CommandLineFixture;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.UsageException;

class FiguresCommandTest extends CommandLineFixture {
    private final List<List<String>> runs = new ArrayList<>();

    /** Stands for the program: draws gray maps, those of 50 and 100 nm darker, and fails for 25 nm. */
    private Collection.Outcome draw(List<String> words) {
        runs.add(words);
        if (words.contains("25nm")) {
            return new Collection.Outcome(4, "", "no memory");
        }
        BufferedImage image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 16; i++) {
            image.setRGB(i % 4, i / 4, words.contains("50nm") || words.contains("100nm") ? 0x404040 : 0x808080);
        }
        String output = words.get(words.indexOf("--output") + 1).replaceFirst("(\\.png)?$", ".png");
        PngWriter.write(Path.of(output), Overwrite.REPLACE, image, Map.of());
        return new Collection.Outcome(0, "", "");
    }

    private String page() throws IOException {
        return Files.readString(folder.resolve("index.html"));
    }

    private int figures(String options) {
        CommandLine command =
                new CommandLine(new FiguresCommand(new Environment(Map.of(), folder).progress(), this::draw));
        command.setOut(new PrintWriter(out));
        command.setErr(new PrintWriter(err));
        command.setExecutionExceptionHandler((failure, line, parsed) -> {
            err.append(failure.getMessage());
            return 6;
        });
        String output = options.contains("--output") ? "" : "--output " + folder + " ";
        return command.execute((output + options).split(" ", -1));
    }

    @Test
    void theManifestHasTheThesissFiguresInOrderEachPictureWithItsFile() {
        List<Figure> all = Figure.all();
        assertThat(all.stream().map(Figure::number).collect(Collectors.joining(" ")))
                .isEqualTo(
                        "2.6 2.8 2.11 3.1 4.5 4.6 4.9 table-4.1 4.10 4.11 5.2 5.3 5.4 5.5 5.6 5.7 5.8 5.9 5.10 5.11 5.12 5.13"
                                + " 5.14 5.15 5.16 5.17 5.18");
        Figure.Sizes sizes = new Figure.Sizes(24, "48x36", "380:780:100");
        List<Figure.Drawing> drawings = all.stream()
                .flatMap(figure -> figure.drawings(patch -> patch, sizes, folder).stream())
                .toList();
        assertThat(drawings).extracting(Figure.Drawing::file).doesNotHaveDuplicates();
        assertThat(drawings)
                .filteredOn(drawing -> drawing.picture().plot() == null)
                .allSatisfy(drawing -> assertThat(String.join(" ", drawing.command()))
                        .doesNotContain("{")
                        .contains(folder.toString())
                        .matches("(precompute|brdf-map|evaluate|inspect|render) .*"));
        assertThat(all)
                .allSatisfy(figure ->
                        assertThat(List.of(figure.thesis(), figure.ours())).doesNotContain(""));
        assertThat(Figure.select(List.of("5.10", "4.9")))
                .extracting(Figure::number)
                .containsExactly("4.9", "5.10");
        assertThatThrownBy(() -> Figure.select(List.of("5.99")))
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith("--only 5.99: no such figure; choose from 2.6, 2.8, 2.11, 3.1");
    }

    @Test
    void aTableHasTheThesissNumbersOursAndTheDifference() throws IOException {
        Files.writeString(
                folder.resolve("table-4.1-elaphe.json"),
                "{\"peaks_at_maxima\": {\"mean_m\": 1144.11e-9, \"variance_m2\": 0.08e-18}}");

        assertThat(figures("--only table-4.1")).isZero();

        assertThat(out.toString()).contains("FLSS, Elaphe, mean nm: thesis 1144.28, here 1144.11, difference -0.17");
        assertThat(page()).contains("<td>variance nm2</td><td>0.15</td><td>0.08</td><td>-0.07</td>");
    }

    @Test
    void eachPictureIsDrawnByItsCommandAndWhatFailsIsLeftOut() throws IOException {
        assertThat(figures("--only 5.5 --size 24")).isEqualTo(4);
        assertThat(err.toString()).contains("figure 5.5-blaze-25nm.png: no memory");
        assertThat(runs).hasSize(6);
        assertThat(runs.get(2))
                .startsWith("brdf-map", "--preset", "thesis")
                .containsSequence("--wavelength-step", "10nm", "--no-annotate")
                .containsSequence("--size", "24")
                .containsSequence(
                        "--exposure", folder.resolve("5.5-blaze-1nm.png").toString())
                .containsSequence("--patch", "blaze")
                .endsWith("--resume");
        assertThat(page())
                .contains("Figure 5.5", "5.5-blaze-10nm.png", "--wavelength-step 10nm")
                .as("what was not drawn")
                .doesNotContain("5.5-blaze-25nm.png", "Figure 5.6")
                .as("two pictures are equal, the others' grays differ by 26 in lightness")
                .contains("CIEDE2000 0.0 (median)")
                .containsPattern("CIEDE2000 2[0-9] \\(median\\)");

        runs.clear();
        assertThat(figures("--only 4.9 --force")).isZero();
        assertThat(runs.get(0))
                .startsWith("evaluate", "--patch", "blaze", "--theta-i", "75")
                .endsWith("--force");
        runs.clear();
        assertThat(figures("--only 4.9")).isZero();
        assertThat(runs).as("it is there").isEmpty();
        assertThat(page()).contains("Figure 4.9");
    }

    @Test
    void aVerdictIsWhatTheCheckMeasures() throws IOException {
        figures("--only 5.5,5.6 --size 24");
        // The gray of 100 nm lies 26 from that of 1 nm in lightness, those of 5 and 10 nm are equal to it.
        assertThat(out.toString())
                .containsPattern(
                        "'10 nm lose nothing, 100 nm do' holds: 95th percentile of CIEDE2000 from blaze-1nm: blaze-10nm 0\\.00, blaze-100nm 2")
                .contains(
                        "5.6 differs: '5 nm lose nothing, 10 nm do' fails: 95th percentile of CIEDE2000 from elaphe-1nm:"
                                + " elaphe-5nm 0.00, elaphe-10nm 0.00 (< 2.3, > 2.3)");
        assertThat(page()).contains("<b>Check:</b> differs: '5 nm lose");
    }

    /** The program of this test writes none of the files that plots and checks of 4.5 and 5.11 read. */
    @Test
    void withoutResultsAPlotIsLeftOutAndAFigureIsNotDecided() throws IOException {
        assertThat(figures("--only 4.5,5.11 --size 24")).isZero();
        assertThat(folder.resolve("5.11-blaze-errors.png")).doesNotExist();
        assertThat(folder.resolve("4.5-relief.png")).doesNotExist();
        assertThat(page()).contains("not decided: 'the more, the sharper' is open", "; missing: 1, 2, 3, 7<");
    }

    /** Of Table 4.1 only one row is there, and its variance is twenty times the thesis's. */
    @Test
    void aRuleThatFailsDecidesWithoutTheMissingNumbers() throws IOException {
        Files.writeString(
                folder.resolve("table-4.1-elaphe.json"),
                "{\"peaks_at_maxima\": {\"mean_m\": 1144.11e-9, \"variance_m2\": 3e-18}}");

        assertThat(figures("--only table-4.1 --json")).isZero();

        JsonNode verdict = new ObjectMapper().readTree(out.toString()).at("/verdicts/0");
        assertThat(verdict.at("/agrees").isBoolean()).isTrue();
        assertThat(verdict.at("/agrees").booleanValue()).isFalse();
        assertThat(verdict.at("/measured").textValue())
                .startsWith("'same variance' fails: ratio of variances: elaphe 20.0 (< 2.46); 'same mean' is open");
        assertThat(verdict.at("/missing")).extracting(JsonNode::textValue).contains("blaze", "pq-elaphe");
    }

    @Test
    void quickPicturesAreSmallAsTheirPageSays() throws IOException {
        figures("--only 5.5,5.14 --quick");
        assertThat(page()).contains("<p>Drawn with --quick: ");
        assertThat(runs.get(0)).containsSequence("--size", "96");
        assertThat(runs.get(runs.size() - 1)).containsSequence("--size", "160x120");
        assertThat(figures("--only 2.8 --output " + folder.resolve("a/b")))
                .as("folders above are made")
                .isZero();
        assertThat(folder.resolve("a/b/2.8-functions.png")).isRegularFile();
    }

    @Test
    void aSceneOfAFigureHasItsValues() throws IOException {
        figures("--only 5.17,5.18");
        assertThat(Files.readString(folder.resolve("5.17-4.1.scene.json"))).contains("\"fieldOfView\" : \"4.1 deg\"");
        // (0.6, 0.5) turned by 10 degrees.
        assertThat(Files.readString(folder.resolve("5.18-10.scene.json"))).containsPattern("\\[ 0\\.504\\d*, 0\\.596");
    }

    @Test
    void aPageThatOthersWroteStays() throws IOException {
        Files.writeString(folder.resolve("index.html"), "mine");
        assertThat(figures("--only 5.5")).isEqualTo(6);
        assertThat(err.toString()).contains("it exists and is no page of these figures");
        assertThat(runs).isEmpty();
    }

    @Test
    void aPageOfOtherFiguresStaysAndOneOfTheSameIsContinued() throws IOException {
        assertThat(figures("--only 4.9")).isZero();
        String first = page();
        assertThat(figures("--only 4.9 --size 32")).isEqualTo(6);
        assertThat(figures("--only table-4.1")).isEqualTo(6);
        assertThat(page()).isEqualTo(first);
        assertThat(figures("--only 4.9")).isZero();
        assertThat(figures("--only table-4.1 --force")).isZero();
    }
}
