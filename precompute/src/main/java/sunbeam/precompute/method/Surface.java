package sunbeam.precompute.method;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.StatisticsCache;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.PatchIdentity;

/**
 * Surface and light for which methods are planned.
 *
 * @param map heights without missing samples
 * @param levels the map's distinct heights, and their index at each sample
 * @param identity identity of the surface in caches
 * @param cie observer and illuminant
 */
public record Surface(
        HeightMap map, HeightLevels levels, PatchIdentity identity, CieTable cie, StatisticsCache statistics) {
    public Surface(HeightMap map, HeightLevels levels, PatchIdentity identity, CieTable cie) {
        this(map, levels, identity, cie, StatisticsCache.NONE);
    }

    /** Returns the surface of a loaded patch, under D65. */
    public static Surface of(Patch patch) {
        return of(patch, patch.digest());
    }

    /** Returns the surface of a loaded patch, under D65, for plans only: without the slow digest of all heights. */
    public static Surface withoutIdentity(Patch patch) {
        return of(patch, "");
    }

    private static Surface of(Patch patch, String digest) {
        HeightMap map = patch.heights();
        PatchIdentity identity =
                new PatchIdentity(patch.name(), map.columns(), map.rows(), map.pitchX(), map.pitchY(), digest);
        return new Surface(map, HeightLevels.of(map), identity, CieTable.load());
    }

    public Surface withLight(CieTable light) {
        return new Surface(map, levels, identity, light, statistics);
    }

    public Surface withStatistics(StatisticsCache newStatistics) {
        return new Surface(map, levels, identity, cie, newStatistics);
    }

    /** @throws SettingException for light with spectral lines */
    void requireSmoothLight() {
        if (!cie.isSmooth()) {
            throw new SettingException(
                    Methods.METHOD,
                    "is for light as smooth as daylight, and this one (" + cie.description()
                            + ") has lines; take full or table");
        }
    }

    public Planner planner() {
        return new Planner(map, levels, cie).withStatistics(statistics);
    }

    /** Identifies surface and light in cache keys. */
    String key() {
        return identity.digest() + "|" + cie.digest();
    }
}
