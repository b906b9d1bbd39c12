package sunbeam.precompute.analysis;

/**
 * Measures of the strongest wave that decide whether it is order.
 *
 * @param broad whether most of the power within 15 % of the frequency is not in one line, as of grown surfaces
 * @param periods number in the scan along the wave
 * @param samples per period, along the axis that has fewer
 * @param share of the variance, without structure coarser than two periods, near the wave, its like in other directions and its overtones, 0..1
 * @param lines share of the whole variance in plane waves: the wave, its like in other directions and two overtones of each, 0..1
 * @param contrast mean power in the wave's direction over the median of twelve directions, at its frequency
 * @param ring mean power at the wave's frequency, in all directions, over that of coarser waves
 * @param prominence power of the wave's peak over the median beside it: at other frequencies in its direction, and at its frequency along x
 * @param significance power of the wave's peak over the median around it
 * @param unseen share of the variance finer than light resolves, 0..1
 * @param chance significance and prominence that, among the waves that were stated, noise reaches in 1 of 100 scans; infinite if none was stated
 * @param halfWidth half width of the frequency's 95 % interval, relative; infinite before it is known
 */
record Evidence(
        boolean broad,
        double periods,
        double samples,
        double share,
        double lines,
        double contrast,
        double ring,
        double prominence,
        double significance,
        double unseen,
        double chance,
        double halfWidth) {
    // Share of the variance; leakage of other waves stays below it.
    private static final double LEAST_STATED = 0.01;

    Evidence within(double known) {
        return new Evidence(
                broad, periods, samples, share, lines, contrast, ring, prominence, significance, unseen, chance, known);
    }

    /** Half width of the frequency's 95 % interval, periods over the scan. */
    double strays() {
        return halfWidth * periods;
    }

    boolean isStated() {
        return share >= LEAST_STATED && Math.min(significance, prominence) >= chance;
    }
}
