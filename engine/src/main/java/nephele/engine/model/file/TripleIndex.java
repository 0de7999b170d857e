package nephele.engine.model.file;

/** Numbers integer triples in the order of their first occurrence, without an object for each. */
final class TripleIndex {
    private final IntList first = new IntList();
    private final IntList second = new IntList();
    private final IntList third = new IntList();

    /** A hash table of triple numbers plus one; 0 for an empty slot. */
    private int[] slots = new int[64];

    int size() {
        return first.size();
    }

    int first(int number) {
        return first.at(number);
    }

    int second(int number) {
        return second.at(number);
    }

    int third(int number) {
        return third.at(number);
    }

    /** Returns the number of a triple; for a new one, {@link #size} before the call. */
    int numberOf(int a, int b, int c) {
        int slot = slot(a, b, c);
        if (slots[slot] != 0) {
            return slots[slot] - 1;
        }
        first.add(a);
        second.add(b);
        third.add(c);
        slots[slot] = size();
        if (2 * size() > slots.length) {
            grow();
        }
        return size() - 1;
    }

    private int slot(int a, int b, int c) {
        int slot = mix(a, b, c) & (slots.length - 1);
        while (slots[slot] != 0 && !isAt(slots[slot] - 1, a, b, c)) {
            slot = (slot + 1) & (slots.length - 1);
        }
        return slot;
    }

    private boolean isAt(int number, int a, int b, int c) {
        return first.at(number) == a && second.at(number) == b && third.at(number) == c;
    }

    private void grow() {
        slots = new int[2 * slots.length];
        for (int number = 0; number < size(); number++) {
            slots[slot(first.at(number), second.at(number), third.at(number))] = number + 1;
        }
    }

    private static int mix(int a, int b, int c) {
        long mixed = (a * 0x9E3779B97F4A7C15L) ^ (b * 0xC2B2AE3D27D4EB4FL) ^ (c * 0x165667B19E3779F9L);
        mixed = (mixed ^ (mixed >>> 29)) * 0xBF58476D1CE4E5B9L;
        return (int) (mixed >>> 32);
    }
}
