package sunbeam.app.commands.evaluate;

import java.util.Locale;
import sunbeam.precompute.evaluation.BinSums;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.NmmMethod;
import sunbeam.precompute.method.PqMethod;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.setting.Choices;

/** Who evaluates a response. */
enum ResponseMethod {
    /** Direct sums over the surface. */
    REFERENCE,
    FULL,
    NMM,
    PQ,
    /** {@link BinSums}: what {@code full} computes. */
    BINS;

    private MethodType type() {
        return switch (this) {
            case REFERENCE -> ReferenceMethod.TYPE;
            case FULL, BINS -> FullMethod.TYPE;
            case NMM -> NmmMethod.TYPE;
            case PQ -> PqMethod.TYPE;
        };
    }

    /**
     * The method as chosen.
     *
     * @throws sunbeam.precompute.setting.SettingException for choices that do not belong to it
     */
    Method of(Choices choices) {
        return Methods.of(in(choices));
    }

    /** The choices with the method. */
    Choices in(Choices choices) {
        return choices.with(Methods.METHOD, type());
    }

    /** Lower-case name. */
    String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
