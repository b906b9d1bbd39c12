package sunbeam.precompute.method;

import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.plan.Accuracy;
import sunbeam.precompute.plan.GaussianArea;
import sunbeam.precompute.plan.Neighbourhood;
import sunbeam.precompute.plan.TableChoices;

/**
 * One wavelength per diffraction order, weighted by the order's width (unweighted with the thesis's preset), under a
 * Gaussian window.
 *
 * @param table the tables, and the wavelengths near the specular direction
 * @param neighbourhood of bins around each frequency
 * @param area the window and its average
 */
public record NmmMethod(TableChoices table, Optional<Neighbourhood> neighbourhood, GaussianArea area)
        implements Method {
    /** Its name and settings. */
    public static final MethodType TYPE = new MethodType(
            "nmm",
            "one wavelength per diffraction order, weighted by the order's width.",
            BinSettings.ALL,
            choices -> new NmmMethod(
                    TableChoices.of(choices), BinSettings.neighbourhood(choices), GaussianArea.of(choices)));

    /** Planned for a tolerance, in sunlight. */
    public static NmmMethod within(double tolerance) {
        return new NmmMethod(
                TableChoices.of(new Accuracy.ByTolerance(tolerance)), Optional.empty(), GaussianArea.STANDARD);
    }

    @Override
    public MethodType type() {
        return TYPE;
    }

    @Override
    public ReferenceMethod exact(HeightMap map) {
        return new ReferenceMethod(area);
    }
}
