package nephele.lab.bound;

/**
 * What a bounding volume says about pairs of models.
 *
 * @param apart pairs whose triangles do not touch
 * @param reported pairs that touch by the volume
 * @param missed pairs whose triangles touch, but not the volumes
 */
record ContactCounts(long pairs, long apart, long reported, long missed) {
    static ContactCounts over(ModelPairs pairs, Bound bound, long from, long count) {
        long apart = 0;
        long reported = 0;
        long missed = 0;
        for (long number = from; number < from + count; number++) {
            ModelPairs.Pair pair = pairs.pair(number);
            boolean touches = pair.touch(bound);
            boolean isContact = bound == Bound.TRIANGLES ? touches : pair.touch(Bound.TRIANGLES);
            apart += isContact ? 0 : 1;
            reported += touches ? 1 : 0;
            missed += isContact && !touches ? 1 : 0;
        }
        return new ContactCounts(count, apart, reported, missed);
    }

    /** Returns the share of the pairs apart that are reported as a contact, per cent. */
    double falsePercent() {
        long contacts = pairs - apart;
        return apart == 0 ? 0 : 100.0 * (reported - contacts + missed) / apart;
    }

    double reportedPercent() {
        return 100.0 * reported / pairs;
    }
}
