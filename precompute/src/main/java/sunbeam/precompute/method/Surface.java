package sunbeam.precompute.method;

import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.HeightLevels;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.Planner;
import sunbeam.precompute.plan.Roughness;
import sunbeam.precompute.setting.SettingException;

/**
 * Surface and light for which methods are planned: heights without missing samples, a name for messages, and for cache keys the SHA-256 of
 * grid and heights, in hexadecimal.
 */
public record Surface(HeightLevels levels, String name, String digest, CieTable cie, Roughness.Cache statistics) {
    public Surface(HeightMap map, String name, String digest, CieTable cie) {
        this(new HeightLevels(map), name, digest, cie, Roughness.Cache.NONE);
    }

    public static Surface of(Patch patch) {
        return new Surface(patch.heights(), patch.name(), patch.heights().digest(), CieTable.load());
    }

    /** Returns the surface of a patch for plans only: without the slow digest of all heights. */
    public static Surface withoutIdentity(Patch patch) {
        return new Surface(patch.heights(), patch.name(), "", CieTable.load());
    }

    public HeightMap map() {
        return levels.map();
    }

    public Surface withLight(CieTable light) {
        return new Surface(levels, name, digest, light, statistics);
    }

    public Surface withStatistics(Roughness.Cache newStatistics) {
        return new Surface(levels, name, digest, cie, newStatistics);
    }

    void requireSmoothLight() {
        if (!cie.isSmooth()) {
            throw new SettingException(
                    Methods.METHOD,
                    "is for light as smooth as daylight, and this one (" + cie.description()
                            + ") has lines or narrow peaks; take full or table");
        }
    }

    public Planner planner() {
        return new Planner(levels, cie, statistics);
    }

    String key() {
        return digest + "|" + cie.digest();
    }
}
