package sunbeam.precompute.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.prepare.ScanFault;

class VerdictTest {
    private static Patch scan(HeightMap map, Patch.Repetition repetition, ScanFault... faults) {
        return new Patch("scan", map, map, "a test", List.of(), List.of(), List.of(), List.of(faults), repetition);
    }

    private static Patch piece(HeightMap map, ScanFault... faults) {
        return scan(map, Patch.Repetition.NONE, faults);
    }

    private static Patch piece(DoubleBinaryOperator heights) {
        return piece(Surfaces.of(150, 150, 100e-9, heights));
    }

    private static double sine(double position, double period) {
        return 50e-9 * Math.sin(2 * Math.PI * position / period);
    }

    private static String verdict(Patch patch) {
        return Verdict.of(patch, GratingPeriod.of(patch), 0, 0).sentence();
    }

    private static Stream<Arguments> sentences() {
        return Stream.of(
                // sin theta = lambda / d, of 400 and 700 nm: 19.5 and 35.7 degrees, of which the interval is a
                // thousandth.
                Arguments.of(
                        "A grating of 1\\.(1999|20)[0-9]* um \\(1\\.(19|20)[0-9]* to 1\\.20[0-9]*\\) across 90 degrees:"
                                + " first-order colors at 19 to 36 degrees under light from above",
                        piece((x, y) -> sine(y, 1.2e-6))),
                Arguments.of("A grating of 1\\.1.*", piece(Surfaces.of(512, 1, 40e-9, (x, y) -> sine(x, 1.1e-6)))),
                Arguments.of("A grating of 1\\.1.*", piece(Surfaces.of(1, 512, 40e-9, (x, y) -> sine(y, 1.1e-6)))),
                Arguments.of(
                        ".*light from above has no first-order colors",
                        piece(Surfaces.of(150, 150, 20e-9, (x, y) -> sine(x, 0.3e-6)))),
                Arguments.of(
                        "A grating of 1\\.[27].* across (0|90) degrees, crossed by lines of about 1\\.[27] um across (90|0)"
                                + " degrees: .*",
                        piece((x, y) -> sine(y, 1.2e-6) + sine(x, 1.7e-6))),
                // Two equally strong waves, one of half the period.
                Arguments.of("A grating of 1\\.20.*", piece((x, y) -> sine(x, 1.2e-6) + sine(x + 0.1e-6, 0.6e-6))),
                Arguments.of(
                        "A grating of 2\\.0.* across 0 degrees, overlaid by lines of about 1\\.3 um across 0 degrees:.*",
                        piece((x, y) -> sine(x, 2e-6) + sine(x, 1.3e-6))),
                Arguments.of(
                        "A rhombic lattice .*",
                        piece(FaultyScan.Grating.ROWS.draw(13).map())),
                // Every second line is a little higher: the strongest wave is an overtone.
                Arguments.of(
                        "A repeated patch with a period of 2 um.*",
                        scan(
                                Surfaces.of(120, 40, 50e-9, (x, y) -> 0.3 * sine(x, 2e-6) + 1.6 * sine(x, 1e-6)),
                                Patch.Repetition.PERIODIC)),
                // The flat top of a lamella is no field of lines.
                Arguments.of(
                        "A repeated patch with a period of 2\\.5 um across 0 degrees.*",
                        scan(
                                Surfaces.of(128, 32, 2.5e-6 / 128, (x, y) -> x < 1.25e-6 ? 137.5e-9 : 0),
                                Patch.Repetition.PERIODIC)),
                // Lines 120 nm apart have no waves of 190 nm or more, the range of visible light.
                Arguments.of(
                        "No order found: most of the relief is finer than light resolves.*",
                        piece(Surfaces.of(200, 200, 20e-9, (x, y) -> 2 * Math.abs(sine(x + 0.03 * y, 0.24e-6))))),
                // A shallower line in two or three is a wave of the longer period, which the light sees.
                Arguments.of(
                        "A grating of 2\\.(39|40).* across 0 degrees, overlaid by lines of about 1\\.2 um across 0 degrees:.*",
                        piece((x, y) -> sine(x, 1.2e-6) + 0.4 * sine(x, 2.4e-6))),
                Arguments.of(
                        "A grating of (2\\.99|3\\.00).* across 0 degrees, overlaid by lines of about 1 um across 0 degrees:.*",
                        piece((x, y) -> sine(x, 1e-6) + 0.4 * sine(x, 3e-6))),
                // One line in three or two differs by a tenth.
                Arguments.of(
                        "A grating of 1\\.(79|80).* across 0 degrees, overlaid by lines of about 600 nm across 0 degrees:.*",
                        piece((x, y) -> sine(x, 0.6e-6) + 0.1 * sine(x, 0.9e-6))),
                Arguments.of(
                        "A grating of 2\\.(39|40).* across 0 degrees, overlaid by lines of about 1\\.2 um across 0 degrees:.*",
                        piece((x, y) -> sine(x, 1.2e-6) + 0.1 * sine(x, 2.4e-6))),
                // Such a period is seen fewer than six times.
                Arguments.of(
                        "A grating of 2\\.(59|60).* across 0 degrees, overlaid by lines of about 1\\.3 um across 0 degrees:.*",
                        piece((x, y) -> sine(x, 1.3e-6) + 0.1 * sine(x, 2.6e-6))),
                // Eleven and a half samples a period: sampling makes a wave of twice the period of the 11th overtone.
                Arguments.of(
                        "A grating of (0\\.99|1\\.00).*\\) across 0 degrees:.*",
                        piece(Surfaces.of(256, 256, 1e-6 / 11.5, (x, y) -> Math.signum(sine(x, 1e-6)) * 5e-8))),
                // A block of rows, little higher than the lines, is no longer period.
                Arguments.of(
                        "A grating of (0\\.99|1\\.00).*\\) across 90 degrees:.*",
                        piece(Surfaces.sampled(
                                256,
                                256,
                                20e-6 / 256,
                                (column, row) -> Math.signum(sine(20e-6 / 256 * (row + 0.3), 1e-6)) * 5e-8
                                        + (row >= 100 && row < 130 ? 1e-7 : 0)))),
                // Too few samples, or too small a field, to see lines three times.
                Arguments.of(
                        "Too little to judge: 7 x 4 samples.*",
                        piece(Surfaces.of(7, 4, 1e-6, (x, y) -> 50e-9 * Math.sin(2e6 * x) * Math.cos(3e6 * y)))),
                Arguments.of(
                        "Too little to judge: only 2\\.8 periods of about 1\\.6 um;.*",
                        piece(Surfaces.of(128, 128, 35e-9, (x, y) -> (x - 0.1 * y) % 1.6e-6 < 0.5e-6 ? -110e-9 : 0))),
                Arguments.of(
                        "Too little to judge: only 2\\.[45] periods of about 1\\.6 um;.*",
                        piece(Surfaces.of(128, 128, 4e-6 / 128, (x, y) -> sine(x + 0.1 * y, 1.6e-6)))));
    }

    @ParameterizedTest
    @MethodSource("sentences")
    void eachKindOfReliefHasItsSentence(String pattern, Patch patch) {
        assertThat(verdict(patch)).matches(pattern);
    }

    /**
     * sin theta = +-lambda / d - 1/2: -9.6 and 4.8, -56.4 and beyond -90 degrees for 1.2 um; +-lambda / d - 0.17: 2.1 to 11.2 degrees, and
     * -22.6 to -32.8 for 1.9 um. Light along the lines has the angles of light from above.
     */
    @ParameterizedTest
    @CsvSource({
        "1.2e-6, 30, 0, at -10 to 5 degrees and at -90 to -56 degrees",
        "1.2e-6, 30, 90, at 19 to 36 degrees and at -36 to -19 degrees",
        "1.9e-6, 10, 0, at 2 to 11 degrees and at -33 to -23 degrees"
    })
    void obliqueLightHasAscendingAnglesOnEitherSideOfItsMirrorDirection(
            double period, double light, double phi, String angles) {
        Patch patch = piece((x, y) -> sine(x, period));
        assertThat(Verdict.of(patch, GratingPeriod.of(patch), light, phi).sentence())
                .contains("first-order colors " + angles + " under light at");
    }

    /** As in JSON: above -90 and at most 90 degrees, with tenths. */
    @Test
    void oneRangeHoldsForAllDirections() {
        assertThat(GratingPeriod.of(piece((x, y) -> sine(y, 1.2e-6))).describe())
                .contains(", in direction 90.0 +- 0.1 degrees; seen 12.5 times");
        double slope = Math.tan(Math.toRadians(-1.2));
        GratingPeriod period = GratingPeriod.of(piece((x, y) -> sine(x + slope * y, 1.2e-6)));
        assertThat(period.describe()).contains(", in direction -1.2 +- 0.1 degrees");
        assertThat(period.directions()).containsExactly(-1L);
        assertThat(verdict(piece((x, y) -> sine(x + slope * y, 1.2e-6)))).contains(" across -1 degree: ");
        // To -89.9 degrees.
        assertThat(period.turned(Math.toRadians(-88.7)).directions()).containsExactly(90L);
    }

    /** Along other directions or of other periods, a grating has no waves; its gloss is not white. */
    @Test
    void whatIsNotSoughtIsNoWhiteGloss() {
        Patch patch = piece((x, y) -> sine(x, 1.2e-6));
        OptionalDouble oblique = OptionalDouble.of(Math.toRadians(45));
        GratingPeriod across = GratingPeriod.among(patch, oblique, 0, Double.POSITIVE_INFINITY);
        assertThat(across.reason()).startsWith("no order found along azimuth 45 degrees; ");
        GratingPeriod longer = GratingPeriod.among(patch, OptionalDouble.empty(), 2e-6, 3e-6);
        assertThat(longer.reason()).startsWith("no order found with a period of 2 um to 3 um; ");
    }

    /** The lines end in the middle of the scan: the part that was measured has its period. */
    @Test
    void rowsThatHoldNoMeasurementAreLeftOut() {
        HeightMap stopped = Surfaces.of(150, 150, 100e-9, (x, y) -> y < -10e-6 ? 0 : sine(x + 0.2 * y, 1.2e-6));
        Crop above = new Crop(0, 15e-6, 5e-6, 15e-6);
        List<Integer> rows = IntStream.range(100, 150).boxed().toList();
        ScanFault fault =
                new ScanFault("rows 101 to 150 hold no measurement", Optional.of(above), Optional.empty(), rows, "");
        GratingPeriod period = GratingPeriod.of(piece(stopped, fault));
        assertThat(period.isSure()).isTrue();
        assertThat(1.2e-6 / Math.hypot(1, 0.2)).isBetween(period.low(), period.high());
    }

    private static double wave(double x, double y, double period, double degrees) {
        double angle = Math.toRadians(degrees);
        return sine(x * Math.cos(angle) + y * Math.sin(angle), period);
    }

    /**
     * Waves alike that cancel each other along lines of the scan, or are so close that the constant depends on their angle: 2.7 times as
     * much for 20 degrees.
     */
    @ParameterizedTest
    @CsvSource({"45, 135, square", "44, 136, square", "40, 140, rhombic", "30, 150, hexagonal", "-10, 10, rhombic"})
    void theConstantOfALatticeIsInItsInterval(double one, double two, String kind) {
        double truth = 1.4142 / Math.sin(Math.toRadians(two - one));
        Patch patch = piece(Surfaces.of(
                200, 200, 100e-9, (x, y) -> wave(x, y, 1.4142e-6, one) + wave(x + 1e-7, y, 1.4142e-6, two)));
        String sentence = verdict(patch);
        Matcher matcher = Pattern.compile("A " + kind + " lattice with a constant of .* um \\((.*) to (.*?)\\), .*")
                .matcher(sentence);
        assertThat(matcher.matches()).as(sentence).isTrue();
        // A hundredth of a line over 14 periods, and 2 * 2.7 * sqrt(2) times that of the angle, is 0.7 %.
        assertThat(truth)
                .isBetween(Double.parseDouble(matcher.group(1)), Double.parseDouble(matcher.group(2)))
                .isCloseTo(
                        0.5 * (Double.parseDouble(matcher.group(1)) + Double.parseDouble(matcher.group(2))),
                        within(0.007 * truth));
    }

    /** Steps of 3 nm on a tilted plane; of a grating's few heights, or below its relief, they are no fault. */
    @Test
    void roundedHeightsOfAPlaneAreNoGrating() {
        DoubleBinaryOperator plane = (x, y) -> 1.5e-3 * x + 0.5e-3 * y;
        assertThat(verdict(leveled((x, y) -> 3e-9 * Math.rint(plane.applyAsDouble(x, y) / 3e-9))))
                .isEqualTo(
                        "Too little to judge: the heights come in steps of 3 nm, as high as the relief; export the scan with more digits");
        assertThat(verdict(leveled((x, y) ->
                        3e-9 * Math.rint((plane.applyAsDouble(x, y) + 0.1 * sine(x, 1.2e-6)) / 3e-9))))
                .startsWith("A grating of ");
        assertThat(verdict(leveled((x, y) -> sine(x, 1.3e-6) > 45e-9 ? 3e-9 : 0)))
                .startsWith("A grating of ");
    }

    /** An oblique step, on a surface that is constant along x, is the only bend along x. */
    @Test
    void aStepAcrossLinesIsNoRounding() {
        assertThat(verdict(leveled((x, y) ->
                        sine(y, 1.5e-6) + 0.4 * sine(y, 3e-6) + 5e-3 * x + (x + 0.3 * y > 9e-6 ? 180e-9 : 0))))
                .doesNotContain("come in steps");
    }

    private static Patch leveled(DoubleBinaryOperator heights) {
        return piece(Leveling.PLANE.apply(Surfaces.of(150, 150, 100e-9, heights)));
    }

    /** The lines of 4.5 to 6 periods reach over most directions; whole waves, and pits that are flat between. */
    @ParameterizedTest
    @CsvSource({
        "4.44, 25, 90, square, false",
        "4, 0, 90, square, false",
        "3.6, 15, 90, square, true",
        "3.3, 8, 60, hexagonal, false"
    })
    void latticesOfFewPeriodsNameTheirCrossingWaves(
            double micrometers, double degrees, double turn, String kind, boolean pits) {
        SplittableRandom random = new SplittableRandom(11);
        DoubleBinaryOperator heights = (x, y) -> {
            double sum = 1e-9 * random.nextGaussian();
            for (double angle = 0; angle < 179; angle += turn) {
                sum += wave(x, y, 1e-6 * micrometers, degrees + angle);
            }
            return pits ? Math.min(sum, 0) : sum;
        };
        assertThat(verdict(piece(Surfaces.of(128, 128, 20e-6 / 128, heights))))
                .startsWith("A " + kind + " lattice ")
                .doesNotContain("crossed");
    }

    /** Waves alike in all directions, of which those seen are strong by chance: a lattice in less than 1 of 100. */
    @ParameterizedTest
    @ValueSource(doubles = {0.03, 0.1, 0.2})
    void aRingOfFewPeriodsIsNoLattice(double width) {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 12; i++) {
            double turns = 2 * Math.PI / random.nextDouble(3e-6, 5e-6);
            DoubleBinaryOperator heights = waves(150, random, () -> {
                double angle = random.nextDouble(Math.PI);
                double length = turns * (1 + width * random.nextGaussian());
                return new double[] {length * Math.cos(angle), length * Math.sin(angle)};
            });
            Patch patch = piece(Surfaces.of(80, 80, 0.25e-6, (x, y) -> 5e-9 * heights.applyAsDouble(x, y)));
            assertThat(verdict(patch)).doesNotContain("lattice", "crossed");
        }
    }

    /** Sums and differences of two waves are overtones; in the second lattice they are as strong, and each wave has 8 % of the variance. */
    @ParameterizedTest
    @CsvSource({"0.7e-6, 0.2e-6, 0.7", "1.2e-6, 0.2e-6, 1.2"})
    void smallHolesAreALattice(double period, double diameter, String constant) {
        HeightMap holes = Surfaces.of(400, 400, 25e-9, (x, y) -> {
            double u = Math.IEEEremainder(x * Math.cos(0.1) + y * Math.sin(0.1), period);
            double v = Math.IEEEremainder(y * Math.cos(0.1) - x * Math.sin(0.1), period);
            return Math.hypot(u, v) < 0.5 * diameter ? -1e-7 : 0;
        });
        assertThat(verdict(piece(holes)))
                .matches("A square lattice with a constant of (" + constant + "|0\\.69|1\\.19).*")
                .doesNotContain("crossed");
    }

    /** Returns a sum of cosines of random phases, of drawn angular frequencies along x and y. */
    private static DoubleBinaryOperator waves(int count, SplittableRandom random, Supplier<double[]> frequencies) {
        double[][] waves = Stream.generate(frequencies).limit(count).toArray(double[][]::new);
        double[] phases = random.doubles(count, 0, 2 * Math.PI).toArray();
        return (x, y) -> IntStream.range(0, count)
                .mapToDouble(i -> Math.cos(waves[i][0] * x + waves[i][1] * y + phases[i]))
                .sum();
    }

    /** Roughness of 15 nm whose spectrum is a Gaussian, with a correlation length of 0.5 um, and as much of a sine. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
    void aSineInRoughnessIsAGrating(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double turns = 1 / 0.5e-6;
        DoubleBinaryOperator rough =
                waves(300, random, () -> new double[] {turns * random.nextGaussian(), turns * random.nextGaussian()});
        double period = 1.8e-6 + 0.1e-6 * seed;
        DoubleBinaryOperator heights = (x, y) ->
                0.4 * wave(x, y, period, 21 * seed) + 15e-9 * Math.sqrt(2.0 / 300) * rough.applyAsDouble(x, y);
        GratingPeriod found = GratingPeriod.of(piece(Surfaces.of(100, 100, 150e-9, heights)));
        assertThat(found.isSeen()).as(found.describe()).isTrue();
        // Half of a line over 6 periods.
        assertThat(found.period()).isBetween(0.92 * period, 1.08 * period);
    }

    /** Waves of about 1.1 um around 20 degrees: the phase corrects the peak of a broad line by a tenth. */
    @Test
    void aMirrorImageHasThePeriodOfTheScan() {
        SplittableRandom random = new SplittableRandom(2);
        DoubleBinaryOperator broad = waves(120, random, () -> new double[] {
            5.7e6 * (0.94 + 0.08 * random.nextGaussian()), 5.7e6 * (0.34 + 0.13 * random.nextGaussian())
        });
        GratingPeriod period = GratingPeriod.of(piece((x, y) -> 5e-9 * broad.applyAsDouble(x - 7.45e-6, y)));
        GratingPeriod mirrored = GratingPeriod.of(piece((x, y) -> 5e-9 * broad.applyAsDouble(7.45e-6 - x, y)));
        assertThat(mirrored.isSure()).isTrue();
        assertThat(mirrored.describe()).isEqualTo(period.describe().replace("in direction ", "in direction -"));
    }

    /** One cell of a hexagonal array of spheres, 0.6 um apart, each of whose waves holds less than a third of the variance. */
    @Test
    void oneCellOfAHexagonalArrayIsALattice() {
        double height = 0.6e-6 * Math.sqrt(3);
        HeightMap cell = Surfaces.of(60, 104, 10e-9, (x, y) -> {
            double corner = Math.hypot(Math.IEEEremainder(x, 0.6e-6), Math.IEEEremainder(y, height));
            double middle =
                    Math.hypot(Math.IEEEremainder(x - 0.3e-6, 0.6e-6), Math.IEEEremainder(y - 0.5 * height, height));
            return Math.sqrt(Math.max(0, 0.09e-12 - Math.pow(Math.min(corner, middle), 2)));
        });
        assertThat(verdict(scan(cell, Patch.Repetition.PERIODIC)))
                .matches(
                        "A hexagonal lattice with a constant of 0\\.(600|601|602) um, its lines 52\\d(\\.\\d+)? nm apart across"
                                + " -30, 30 and 90 degrees: first-order colors at 50 to 90 degrees under light from above");
    }

    /** Smoothed noise in patches of descriptors and of scans: the strongest wave is noise. */
    @ParameterizedTest
    @EnumSource(value = Patch.Repetition.class, names = "PERIODIC", mode = EnumSource.Mode.EXCLUDE)
    void shapelessSurfacesHaveNoOrder(Patch.Repetition repetition) {
        int probable = 0;
        for (long seed = 0; seed < 12; seed++) {
            HeightMap map = PeriodlessSurface.CORRELATED.draw(seed);
            Patch patch = scan(map, repetition);
            Verdict.Code code = Verdict.of(patch, GratingPeriod.of(patch), 0, 0).code();
            // The strongest of few waves may hold much of the variance, so that a grating is not excluded.
            assertThat(code).isIn(Verdict.Code.NONE, Verdict.Code.TOO_LITTLE, Verdict.Code.PROBABLE_GRATING);
            probable += code == Verdict.Code.PROBABLE_GRATING ? 1 : 0;
        }
        // At most a few in a hundred draws.
        assertThat(probable).isLessThan(2);
    }

    /** 8.8 periods on 12 um, each edge displaced by 5 %. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void disorderedGratingsHaveAPeriodUnderAnyRepetition(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        double period = 12e-6 / 8.8;
        double[] edges = IntStream.range(0, 30)
                .mapToDouble(i -> period * (0.5 * (i - 12) + 0.05 * random.nextGaussian()))
                .toArray();
        HeightMap map = Surfaces.of(
                256,
                64,
                12e-6 / 256,
                (x, y) -> 1e-7 * (Arrays.stream(edges).filter(edge -> edge < x).count() % 2));
        for (Patch.Repetition repetition : Patch.Repetition.values()) {
            GratingPeriod found = GratingPeriod.of(scan(map, repetition));
            assertThat(found.isSeen()).as(repetition + ": " + found).isTrue();
            // What the displaced edges may add to 8.8 periods.
            assertThat(found.period()).isBetween(0.93 * period, 1.07 * period);
        }
    }

    /** A spectral line of few periods is wide: its flanks are no second grating. */
    @ParameterizedTest
    @ValueSource(doubles = {4.3, 4.6, 5.2, 5.6, 6.3, 7.7})
    void aSineSeenFewTimesIsNotCrossed(double periods) {
        for (double degrees = 0; degrees < 180; degrees += 11.3) {
            double x = periods / 20e-6 * Math.cos(Math.toRadians(degrees));
            double y = periods / 20e-6 * Math.sin(Math.toRadians(degrees));
            HeightMap map = Surfaces.of(
                    128, 128, 20e-6 / 128, (east, north) -> 75e-9 * Math.sin(2 * Math.PI * (x * east + y * north)));
            assertThat(verdict(piece(map))).startsWith("A grating of ").doesNotContain("crossed");
        }
    }

    /** Waves of one length in all directions: noise must not make one direction stand out. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6})
    void aSurfaceThatIsAlikeInAllDirectionsIsNoGrating(int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        DoubleBinaryOperator ring = waves(100, random, () -> {
            double angle = Math.PI * random.nextDouble();
            double turns = 2 * Math.PI * (1 + 0.04 * random.nextGaussian()) / 1.1e-6;
            return new double[] {turns * Math.cos(angle), turns * Math.sin(angle)};
        });
        HeightMap map = Surfaces.of(200, 200, 100e-9, (x, y) -> 5e-9 * ring.applyAsDouble(x, y));
        assertThat(verdict(piece(map))).startsWith("No grating found: waves of about 1.1 um");
    }

    /** A vibration in step with the scan makes straight lines along or across its rows; lines turned by two degrees are the surface's. */
    @ParameterizedTest
    @CsvSource({"0, across", "90, along", "2, ", "45, "})
    void linesInStepWithTheScanGetANote(double degrees, String where) {
        double angle = Math.toRadians(degrees);
        Patch patch = piece((x, y) -> sine(x * Math.cos(angle) + y * Math.sin(angle), 1e-6));
        Optional<String> note = GratingPeriod.of(patch).caution(patch);
        assertThat(note.isPresent()).isEqualTo(where != null);
        note.ifPresent(words -> assertThat(words).startsWith("lines exactly " + where + " the scan's rows"));
        Patch periodic = scan(patch.scan(), Patch.Repetition.PERIODIC);
        assertThat(GratingPeriod.of(periodic).caution(periodic)).isEmpty();
    }

    /** Half of a period wide, or a hundredth; lines turned by 60 degrees have half of the period that a profile shows. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 20e-9})
    void aStripHasNoDirection(double height) {
        Patch strip = piece(new HeightMap(
                128,
                16,
                20e-6 / 128,
                height / 16,
                Surfaces.of(128, 16, 20e-6 / 128, (x, y) -> sine(x, 2e-6)).heights()));
        assertThat(verdict(strip))
                .startsWith("A grating of 2.0")
                .contains(" along x, its direction is not known: first-order colors");
        assertThat(GratingPeriod.of(strip).directions()).isEmpty();
    }
}
