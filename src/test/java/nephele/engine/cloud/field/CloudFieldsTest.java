package nephele.engine.cloud.field;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.Picture;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Every density of a level has its field in every extent, and an unusable grid is refused with its name. */
class CloudFieldsTest {
    private static final Cloud.Extent VOLUME = new Cloud.Extent.Volume(new Vec3(10, 20, 30), new Vec3(20, 10, 40));
    private static final Cloud.Extent LAYER = new Cloud.Extent.Layer(100, 50);

    private static ExtinctionField field(Cloud.Extent extent, Cloud.Density density, byte[] file) {
        return field(extent, density, file, 0.1);
    }

    private static ExtinctionField field(
            Cloud.Extent extent, Cloud.Density density, byte[] file, double extinctionPerMetre) {
        var cloud = new Cloud("c", extent, CloudTechnique.AUTO, density, extinctionPerMetre, 1, 0);
        return CloudFields.of(cloud, TestPictures.always(file), 0);
    }

    private static byte[] vol(float... values) {
        ByteBuffer file = ByteBuffer.allocate(48 + 4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        file.put(new byte[] {'V', 'O', 'L', 3})
                .putInt(1)
                .putInt(values.length)
                .putInt(1)
                .putInt(1)
                .putInt(1);
        file.putFloat(0).putFloat(0).putFloat(0).putFloat(4).putFloat(5).putFloat(6);
        for (float value : values) {
            file.putFloat(value);
        }
        return file.array();
    }

    @Test
    void aVolumeHoldsItsDensity() {
        var ellipsoid = field(VOLUME, new Cloud.Density.Ellipsoid(), null);
        assertEquals(0.1, ellipsoid.perMetre(10, 24.9, 30));
        assertEquals(0, ellipsoid.perMetre(10, 25.1, 30));
        var puffs = field(VOLUME, new Cloud.Density.Puffs(List.of(new Cloud.Puff(new Vec3(1, 0, 0), 4)), null), null);
        assertEquals(0.1 * Math.exp(-0.5), puffs.perMetre(11, 22, 30), 1e-15);
        var grid = field(VOLUME, new Cloud.Density.Grid("a.vol"), vol(0, 1));
        assertEquals(0.05, grid.perMetre(10, 20, 30), 1e-15);
        assertEquals(0.1, grid.perMetre(20, 25, 50), 1e-15);
        var noise = field(VOLUME, new Cloud.Density.Noise(1, 5, 0.9), null);
        assertTrue(noise.perMetre(10, 20, 30) <= 0.1);
    }

    @Test
    void aLayerHoldsItsDensityEverywhere() {
        var uniform = field(LAYER, new Cloud.Density.Ellipsoid(), null);
        assertEquals(0.1, uniform.perMetre(1e6, 149, -1e6));
        assertEquals(0, uniform.perMetre(0, 151, 0));
        var puffs = field(LAYER, new Cloud.Density.Puffs(List.of(new Cloud.Puff(Vec3.ZERO, 4)), null), null);
        assertEquals(0.1, puffs.perMetre(0, 125, 0));
        var grid = field(LAYER, new Cloud.Density.Grid("a.vol"), vol(0, 1));
        assertEquals(0.1, grid.perMetre(3, 101, 0), 1e-15);
        assertEquals(0.1, grid.perMetre(4003, 149, 7), 1e-12);
        var noise = field(LAYER, new Cloud.Density.Noise(1, 5, 1), null);
        assertTrue(noise.perMetre(1e5, 120, 3e4) > 0);
    }

    @Test
    void aPictureIsSeenFromAboveWithItsTopTowardsMinusZ() {
        var image = new BufferedImage(2, 2, BufferedImage.TYPE_BYTE_GRAY);
        image.getRaster().setSample(1, 0, 0, 255);
        var field = field(VOLUME, new Cloud.Density.Image("a.png"), TestPictures.png(image));
        assertEquals(0.1, field.perMetre(19, 16, 11), 1e-15);
        assertEquals(0.1, field.perMetre(19, 24, 11), 1e-15);
        assertEquals(0, field.perMetre(19, 20, 49), 1e-15);
        assertEquals(0, field.perMetre(1, 20, 11), 1e-15);
    }

    /** τ = −ln(1 − min(α, 254.5/255)) whatever the extinction, the thickness and the colours. */
    @Test
    void alphaIsWhatAColumnHides() {
        var picture = new BufferedImage(4, 1, BufferedImage.TYPE_INT_ARGB);
        int[] alphas = {0, 128, 254, 255};
        for (int i = 0; i < alphas.length; i++) {
            picture.setRGB(i, 0, alphas[i] << 24 | 0x102030 * i);
        }
        byte[] file = TestPictures.png(picture);
        double[] depths = {0, -Math.log(1 - 128 / 255.0), -Math.log(1 / 255.0), Math.log(510)};
        for (double extinction : new double[] {1e-3, 10}) {
            for (double thickness : new double[] {1e-3, 50, 5000}) {
                var extent = new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(4, thickness, 1));
                var cloud =
                        new Cloud("c", extent, CloudTechnique.AUTO, new Cloud.Density.Image("a.png"), extinction, 1, 0);
                ExtinctionField field = CloudFields.of(cloud, TestPictures.always(file), 0);
                for (int i = 0; i < alphas.length; i++) {
                    Ray up = new Ray(i - 1.5, -thickness, 0, 0, 1, 0);
                    double depth = OpticalDepth.along(field, up, 0, 2 * thickness);
                    assertEquals(depths[i], depth, 1e-5);
                    assertEquals(1 - Math.min(alphas[i] / 255.0, 254.5 / 255), Math.exp(-depth), 1e-6);
                }
            }
        }
    }

    @Test
    void sixteenBitsOfAlphaCount() {
        byte[] samples = {0, 0, 0, (byte) 0x80, 0, 0, 1, 0};
        VoxelGrid grid = CloudFiles.densities(new Picture(2, 1, 2, 16, samples));
        assertEquals(-Math.log(1 - 0x8000 / 65535.0), grid.value(0, 0, 0), 1e-6);
        assertEquals(1 / 65535.0, grid.value(1, 0, 0), 1e-9);
    }

    /** A layer keeps its optical depth, and with it its transmittance at any slant, as its thickness goes to 0. */
    @Test
    void aThinLayerOfFixedDepthStaysAsItIs() {
        for (double thickness : new double[] {1000, 1, 1e-3}) {
            var layer =
                    field(new Cloud.Extent.Layer(500, thickness), new Cloud.Density.Ellipsoid(), null, 2 / thickness);
            for (double sine : new double[] {1, 0.3, 0.01}) {
                Ray ray = new Ray(5, 0, 7, Math.sqrt(1 - sine * sine), sine, 0);
                assertEquals(2 / sine, OpticalDepth.along(layer, ray, 0, Double.POSITIVE_INFINITY), 1e-6 / sine);
            }
        }
    }

    @Test
    void anOpaqueCloudIsFinite() {
        var solid = field(VOLUME, new Cloud.Density.Ellipsoid(), null, 1e3);
        double depth = OpticalDepth.along(solid, new Ray(10, 0, 30, 0, 1, 0), 0, 100);
        assertEquals(1e4, depth, 1e-6);
        assertEquals(0, Math.exp(-depth));
    }

    @Test
    void anUnusableGridIsRefusedWithItsNameAndTheRemedy() {
        refused(file -> file.put(0, (byte) 'X'), "is no Mitsuba .vol file");
        refused(file -> file.put(3, (byte) 2), "write version 3");
        refused(file -> file.putInt(20, 3), "3 channels");
        refused(file -> file.putInt(8, 3), "says 3 x 1 x 1 voxels and has 2 values");
        refused(file -> file.putInt(8, 1 << 30).putInt(12, 1 << 30).putInt(16, 16), "voxels and has 2 values");
        refused(file -> file.putInt(12, -1), "at least one voxel");
        refused(file -> file.putFloat(52, Float.NaN), "has density NaN in voxel 1, 0, 0");
        refused(file -> file.putFloat(52, -1), "scale all densities to 0 to 1");
        refused(file -> file.putFloat(52, 1.5f), "has density 1.5");
    }

    private static void refused(Consumer<ByteBuffer> damage, String expected) {
        byte[] file = vol(0, 1);
        damage.accept(ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN));
        var refusal = assertThrows(AssetException.class, () -> VoxelGrid.read("sky/a.vol", file));
        assertTrue(refusal.getMessage().startsWith("sky/a.vol: "), refusal.getMessage());
        assertTrue(refusal.getMessage().contains(expected), refusal.getMessage());
    }
}
