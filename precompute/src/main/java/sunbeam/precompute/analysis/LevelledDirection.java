package sunbeam.precompute.analysis;

import java.util.List;
import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;
import sunbeam.precompute.prepare.Levelling;

/**
 * Another direction in which a surface would spread most of its colours if its scan were levelled otherwise: that of its lines, say,
 * and not that in which its rows jump.
 *
 * @param levelling that changes it
 * @param direction then
 */
public record LevelledDirection(Levelling levelling, PrincipalDirection direction) {
    private static final List<Levelling> LEVELLINGS = List.of(Levelling.QUADRATIC, Levelling.MEDIAN_ROWS);
    // Degrees by which directions must differ.
    private static final double CHANGED = 10;
    // Less is no direction of its own.
    private static final double LEAST_STRENGTH = 0.3;
    // Degrees from a period's direction: what levelling by rows takes away there is the surface's.
    private static final double ITS_OWN = 15;

    /** Of a scan, or the middle of a large one; empty where no levelling changes it, or a period lies in its direction. */
    public static Optional<LevelledDirection> of(HeightMap scan) {
        HeightMap tried = PeriodRemedy.part(scan, PeriodRemedy.middle(scan));
        double azimuth = PrincipalDirection.azimuthDegrees(tried);
        for (Levelling levelling : LEVELLINGS) {
            PrincipalDirection levelled = PrincipalDirection.of(tried.levelled(levelling));
            boolean changes = apart(azimuth, levelled.azimuthDegrees()) > CHANGED;
            if (changes && levelled.strength() >= LEAST_STRENGTH && !hasPeriod(tried, azimuth)) {
                return Optional.of(new LevelledDirection(levelling, levelled));
            }
        }
        return Optional.empty();
    }

    private static boolean hasPeriod(HeightMap scan, double azimuth) {
        return new PeriodFinder(scan, false)
                .all().peaks().stream().anyMatch(peak -> apart(azimuth, Math.toDegrees(peak.direction())) <= ITS_OWN);
    }

    private static double apart(double degrees, double others) {
        return Math.abs(Math.IEEEremainder(degrees - others, 180));
    }
}
