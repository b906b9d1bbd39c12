package sunbeam.precompute.patch;

import java.util.Locale;

/** Units that heights are given in where a file does not say. */
public enum HeightUnit {
    PM(1e-12),
    NM(1e-9),
    UM(1e-6),
    MM(1e-3),
    M(1);

    private final double metres;

    HeightUnit(double metres) {
        this.metres = metres;
    }

    /** One of the unit. */
    public double metres() {
        return metres;
    }

    /** The name as a user writes it. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }
}
