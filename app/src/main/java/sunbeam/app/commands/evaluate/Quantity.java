package sunbeam.app.commands.evaluate;

import sunbeam.precompute.evaluation.ResponseMatrix;

/** What of the reflected light is evaluated. */
enum Quantity {
    /** Relative radiance: the power times what the Fresnel, Kirchhoff and masking factors make of it. */
    RHO("relative radiance rho"),
    /** The diffracted power alone. */
    POWER("power");

    private final String label;

    Quantity(String label) {
        this.label = label;
    }

    String label() {
        return label;
    }

    ResponseMatrix of(ResponseMatrix power) {
        return this == RHO ? power.toRelativeRadiance() : power;
    }
}
