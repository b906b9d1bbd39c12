package sunbeam.precompute.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.Surfaces;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.CoherenceWindow.WindowOrigin;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.optics.Gain;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.reference.ReferenceEvaluator.Power;

/** Symmetries of every surface. */
class SymmetryTruthsTest {
    private static final CoherenceWindow WINDOW = new CoherenceWindow(1e-6);
    private static final HeightMap ROUGH = Surfaces.random(14, 9, 90e-9, 500e-9, 11);

    private final SplittableRandom random = new SplittableRandom(5);
    private final ReferenceEvaluator reference = new ReferenceEvaluator(ROUGH, WINDOW, WindowOrigin.CENTRE);

    private double wavelength() {
        return 380e-9 + 400e-9 * random.nextDouble();
    }

    @Test
    void lightAndViewMayChangePlaces() {
        for (int i = 0; i < 50; i++) {
            DirectionPair there = DirectionPairs.random(random);
            DirectionPair back = new DirectionPair(there.wr(), there.wi());
            double wavelength = wavelength();
            double brdf = Gain.brdf(there, WINDOW, wavelength);
            assertThat(Gain.brdf(back, WINDOW, wavelength)).isCloseTo(brdf, within(1e-9 * brdf));
            assertSame(reference.powers(there, wavelength), reference.powers(back, wavelength));
        }
    }

    @Test
    void powerStaysWhenUvwChangesItsSign() {
        for (int i = 0; i < 50; i++) {
            DirectionPair pair = DirectionPairs.random(random);
            double wavelength = wavelength();
            assertSame(reference.powers(pair, wavelength), reference.powers(DirectionPairs.opposite(pair), wavelength));
        }
    }

    @Test
    void heightOffsetsChangeNothing() {
        // Heights at a millimeter have a rounding of 1e-19 m: phases move by 2 pi 1e-19 / lambda.
        ReferenceEvaluator raised =
                new ReferenceEvaluator(ROUGH.map(height -> height + 1e-3), WINDOW, WindowOrigin.CENTRE);
        for (int i = 0; i < 50; i++) {
            DirectionPair pair = DirectionPairs.random(random);
            double wavelength = wavelength();
            assertSame(reference.powers(pair, wavelength), raised.powers(pair, wavelength));
        }
    }

    private static void assertSame(Power a, Power b) {
        // Powers of this surface are above 1e-5: its rounding is 1e-12 of them.
        assertThat(b.coherent()).isCloseTo(a.coherent(), within(1e-9 * a.coherent() + 1e-15));
        assertThat(b.ensemble()).isCloseTo(a.ensemble(), within(1e-9 * a.ensemble() + 1e-15));
    }
}
