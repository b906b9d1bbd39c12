package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.junit.jupiter.api.Test;
import sunbeam.app.viewer.MapView.GratingOrders;
import sunbeam.app.viewer.PickedLight.Spectrum;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.evaluation.GratingPlane;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.plan.GaussianArea;

/** The picture, the labels and orders that are drawn over a map, and the plot of spectra. */
class ComponentsTest {
    @Test
    void theDialogShowsFilesOfAllFormatsOfTheGuide() throws IOException {
        String guide = Files.readString(Path.of("..", "docs", "guide.md"));
        String formats = guide.substring(guide.indexOf("- Gwyddion `.gwy`"), guide.indexOf("- text: a matrix"));
        FileNameExtensionFilter filter = FileActions.Kind.PATCH.filter();
        assertThat(Pattern.compile("`\\.([a-z0-9]+)`")
                        .matcher(formats)
                        .results()
                        .map(match -> match.group(1)))
                .hasSizeGreaterThan(20)
                .isSubsetOf(filter.getExtensions());
    }

    @Test
    void aPictureOfFewPixelsIsLinearBetweenTheirMiddles() {
        BufferedImage few = random(7, 5);
        PictureView view = new PictureView();
        view.showPicture(few, 19, 15);
        BufferedImage many = view.picture().orElseThrow();
        for (int y = 0; y < 15; y++) {
            for (int x = 0; x < 19; x++) {
                double fromLeft = Math.max(0, Math.min(6, (x + 0.5) * 7 / 19 - 0.5));
                double fromTop = Math.max(0, Math.min(4, (y + 0.5) * 5 / 15 - 0.5));
                for (int shift = 0; shift < 24; shift += 8) {
                    // Java2D rounds places to a 256th of a pixel along both axes, and values to whole numbers.
                    assertThat(many.getRGB(x, y) >> shift & 0xff)
                            .isCloseTo((int) Math.round(linear(few, fromLeft, fromTop, shift)), within(3));
                }
            }
        }
    }

    @Test
    void theLineAboutTheMouseIsThereUntilTheFirstDrag() {
        PictureView view = new PictureView();
        view.setSize(800, 600);
        BufferedImage black = new BufferedImage(800, 600, BufferedImage.TYPE_INT_RGB);
        view.showPicture(black, 800, 600);
        assertThat(painted(view)).as("white letters").contains(0xffffffff);
        view.hideHint();
        assertThat(painted(view)).containsOnly(0xff000000);
        assertThat(view.picture()).contains(black);
    }

    @Test
    void inANarrowViewTheLineIsBrokenAndNotCut() {
        PictureView view = new PictureView();
        view.setSize(260, 300);
        view.showPicture(new BufferedImage(260, 300, BufferedImage.TYPE_INT_RGB), 260, 300);
        int[] painted = painted(view);
        assertThat(painted).contains(0xffffffff);
        for (int y = 0; y < 300; y++) {
            assertThat(painted[260 * y]).as("left edge").isEqualTo(0xff000000);
            assertThat(painted[260 * y + 259]).as("right edge").isEqualTo(0xff000000);
        }
    }

    private static int[] painted(JComponent component) {
        return Pictures.pixels(ViewerInAWindow.painted(component));
    }

    private static BufferedImage random(int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Random random = new Random(8);
        for (int i = 0; i < width * height; i++) {
            image.setRGB(i % width, i / width, random.nextInt(1 << 24));
        }
        return image;
    }

    private static double linear(BufferedImage image, double x, double y, int shift) {
        double sum = 0;
        for (int row = 0; row < image.getHeight(); row++) {
            for (int column = 0; column < image.getWidth(); column++) {
                double weight = Math.max(0, 1 - Math.abs(x - column)) * Math.max(0, 1 - Math.abs(y - row));
                sum += weight * (image.getRGB(column, row) >> shift & 0xff);
            }
        }
        return sum;
    }

    @Test
    void labelsAreWholeAndCoverNoOther() {
        Rectangle bounds = new Rectangle(200, 200);
        Graphics2D graphics = new BufferedImage(200, 200, BufferedImage.TYPE_INT_RGB).createGraphics();
        MapView.Labels labels = new MapView.Labels(graphics, bounds);
        Random random = new Random(5);
        List<Rectangle2D> places = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            Rectangle2D place = labels.paint("+12", 200 * random.nextDouble(), 200 * random.nextDouble());
            if (place != null) {
                assertThat(bounds.contains(place)).isTrue();
                assertThat(places).noneMatch(place::intersects);
                places.add(place);
            }
        }
        assertThat(places).hasSizeGreaterThan(20);
        assertThat(new MapView.Labels(graphics, bounds).paint("x", 198, 100))
                .as("turns away from the edge")
                .isNotNull();
    }

    @Test
    void labelsDoNotLieOnTheAxes() {
        Graphics2D graphics = new BufferedImage(200, 200, BufferedImage.TYPE_INT_RGB).createGraphics();
        MapView.Labels labels = new MapView.Labels(graphics, new Rectangle(200, 200));
        MapView.paintAxes(graphics, labels, 0, 200);
        Random random = new Random(6);
        int count = 0;
        for (int i = 0; i < 200; i++) {
            double along = 200 * random.nextDouble();
            double beside = 96 + 8 * random.nextDouble();
            Rectangle2D place = i % 2 == 0 ? labels.paint("+1", along, beside) : labels.paint("+1", beside, along);
            if (place != null) {
                assertThat(place.intersectsLine(0, 100, 200, 100)).as("x axis").isFalse();
                assertThat(place.intersectsLine(100, 0, 100, 200)).as("y axis").isFalse();
                count++;
            }
        }
        assertThat(count).isGreaterThan(10);
    }

    // Rounding of double precision.
    private static final double ROUNDING = 1e-12;

    /** Compares with GratingPlane for light from any direction. */
    @Test
    void ordersLieWhereTheGratingEquationSendsThem() {
        double period = 1.5e-6;
        double azimuth = Math.toRadians(35);
        GratingPlane plane = new GratingPlane(Math.toRadians(20), Math.toRadians(50), azimuth);
        Direction light = plane.pair(0).wi();
        GratingOrders orders =
                new GratingOrders(new SpatialFrequency(Math.cos(azimuth) / period, Math.sin(azimuth) / period), light);
        int seen = 0;
        for (int order = -4; order <= 4; order++) {
            for (double wavelength : GratingOrders.WAVELENGTHS) {
                double theta = plane.thetaR(order * wavelength / period);
                boolean isThere = Math.abs(theta) < plane.largestThetaR();
                assertThat(orders.direction(order, wavelength).isPresent()).isEqualTo(isThere);
                if (isThere) {
                    Point2D found = orders.direction(order, wavelength).orElseThrow();
                    Direction expected = plane.pair(theta).wr();
                    assertThat(found.getX()).isCloseTo(expected.x(), within(ROUNDING));
                    assertThat(found.getY()).isCloseTo(expected.y(), within(ROUNDING));
                    seen++;
                }
            }
        }
        assertThat(seen).as("marks").isGreaterThan(6);
    }

    private static PickedLight mirror() {
        HeightMap flat = new HeightMap(4, 4, 1e-6, 1e-6, new double[16]);
        DirectionPair specular = new DirectionPair(new Direction(0, 0, 1), new Direction(0, 0, 1));
        CieTable daylight = CieTable.load();
        return new PickedLight(GaussianArea.STANDARD.over(flat, daylight), daylight, specular);
    }

    @Test
    void aSpectrumShowsEveryEighthWavelengthFirstAndIsCopiedWithItsColor() {
        SpectrumPlot plot = plot();
        List<Integer> partial = new ArrayList<>();
        Spectrum whole = mirror().spectrum(
                        spectrum -> {
                            partial.add(spectrum.powers().length);
                            plot.curves.get(0).show(spectrum);
                            assertThat(plot.numbers().isEmpty()).isEqualTo(partial.size() == 1);
                        },
                        () -> false);
        assertThat(partial).containsExactly(11, SpectrumPlot.COUNT);
        plot.curves.get(0).show(whole);
        // D65 by CIE 15, whose range of 360 to 830 nm adds nothing to four digits.
        assertThat(plot.numbers())
                .contains(
                        "XYZ, D65, observer", "  0.950", ", 1.00000, 1.08", "\n380\t1.00000\n385\t", "\n780\t1.00000");
        assertThat(mirror().spectrum(spectrum -> {}, () -> true).powers()).isEmpty();
    }

    @Test
    void aSpectrumThatIsBeingMadeIsSaidToComeUntilItIsThereOrFails() {
        Spectrum spectrum = new Spectrum(
                IntStream.range(0, SpectrumPlot.COUNT).mapToDouble(i -> i % 3).toArray(), "XYZ");
        SpectrumPlot plot = plot();
        int[] without = painted(plot);
        plot.curves.get(0).await(true);
        assertThat(painted(plot)).isNotEqualTo(without);
        plot.curves.get(0).await(false);
        assertThat(painted(plot)).as("failed").isEqualTo(without);

        plot.curves.get(0).await(true);
        plot.curves.get(0).show(spectrum);
        SpectrumPlot other = plot();
        other.curves.get(0).show(spectrum);
        assertThat(painted(plot)).as("there").isEqualTo(painted(other));
        plot.curves.get(1).await(true);
        assertThat(painted(plot)).as("a second one beside it").isNotEqualTo(painted(other));
    }

    private static SpectrumPlot plot() {
        SpectrumPlot plot = new SpectrumPlot();
        plot.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        plot.setForeground(Color.WHITE);
        plot.setSize(300, 100);
        return plot;
    }
}
