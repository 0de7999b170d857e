package nephele.engine.sim.reach;

/** The cells that wait to be visited, each once at a time, in the order in which they came. */
final class CellQueue {
    private final int[] ring;
    private final boolean[] waits;
    private int first;
    private int count;

    CellQueue(int cells) {
        ring = new int[cells];
        waits = new boolean[cells];
    }

    void add(int cell) {
        if (!waits[cell]) {
            waits[cell] = true;
            ring[(first + count) % ring.length] = cell;
            count++;
        }
    }

    /** Takes the next cell; −1 if none waits. */
    int next() {
        if (count == 0) {
            return -1;
        }
        int cell = ring[first];
        first = (first + 1) % ring.length;
        count--;
        waits[cell] = false;
        return cell;
    }
}
