package sunbeam.app.gpu.colors;

import java.util.BitSet;
import java.util.List;
import java.util.stream.Stream;

/** For each mip level the numbers of its tiles. Mutable. */
record TileSet(List<BitSet> ofLevels) {
    static TileSet none(int levels) {
        return new TileSet(Stream.generate(BitSet::new).limit(levels).toList());
    }

    TileSet copy() {
        return new TileSet(
                ofLevels.stream().map(level -> (BitSet) level.clone()).toList());
    }

    /** Counts levels without tiles, too. */
    int levels() {
        return ofLevels.size();
    }

    /** Returns a view of this set. */
    BitSet of(int level) {
        return ofLevels.get(level);
    }

    void add(TileSet other) {
        for (int level = 0; level < ofLevels.size(); level++) {
            of(level).or(other.of(level));
        }
    }

    TileSet without(TileSet other) {
        TileSet rest = copy();
        for (int level = 0; level < ofLevels.size(); level++) {
            rest.of(level).andNot(other.of(level));
        }
        return rest;
    }

    void clear() {
        ofLevels.forEach(BitSet::clear);
    }

    boolean isEmpty() {
        return ofLevels.stream().allMatch(BitSet::isEmpty);
    }

    long count() {
        return ofLevels.stream().mapToLong(BitSet::cardinality).sum();
    }
}
