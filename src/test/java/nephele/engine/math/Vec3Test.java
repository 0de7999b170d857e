package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class Vec3Test {
    @Test
    void aMutableCopyHoldsTheSameNumbers() {
        var vector = new Vec3(1, -2, 1e300).toVector();
        assertEquals(new Vec3(1, -2, 1e300), new Vec3(vector.x, vector.y, vector.z));
    }
}
