package nephele.workshop.art.sprite;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.field.CloudFields;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;

/** A grid of densities for the sample level of grids: one heap of noise, taken at the centres of voxels. */
public final class SampleGrid {
    public static final String FILE = "clouds/heap.vol";

    private static final int WIDE = 44;
    private static final int HIGH = 28;
    private static final float WIDE_METRES = 1100;
    private static final float HIGH_METRES = 700;

    private SampleGrid() {}

    /** Returns the file: Mitsuba's grid volume format, version 3, of 32-bit floats. */
    public static byte[] written() {
        ByteBuffer file = ByteBuffer.allocate(48 + 4 * WIDE * HIGH * WIDE).order(ByteOrder.LITTLE_ENDIAN);
        file.put(new byte[] {'V', 'O', 'L', 3});
        file.putInt(1).putInt(WIDE).putInt(HIGH).putInt(WIDE).putInt(1);
        file.putFloat(-WIDE_METRES / 2).putFloat(-HIGH_METRES / 2).putFloat(-WIDE_METRES / 2);
        file.putFloat(WIDE_METRES / 2).putFloat(HIGH_METRES / 2).putFloat(WIDE_METRES / 2);
        ExtinctionField heap = heap();
        for (int k = 0; k < WIDE; k++) {
            for (int j = 0; j < HIGH; j++) {
                for (int i = 0; i < WIDE; i++) {
                    file.putFloat((float) heap.perMetre(at(i, WIDE), at(j, HIGH), at(k, WIDE)));
                }
            }
        }
        return file.array();
    }

    /** Returns a field whose extinction is the density, in the box of −1 to 1. */
    private static ExtinctionField heap() {
        var noise = new Cloud.Density.Noise(11, 0.55, 1, 0.4, CloudProfile.CUMULUS, null, 0);
        var extent = new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(2, 2, 2));
        return CloudFields.of(new Cloud("heap", extent, CloudTechnique.AUTO, noise, 1, 1, 0), null, 0);
    }

    private static double at(int voxel, int voxels) {
        return (2 * voxel + 1.0) / voxels - 1;
    }
}
