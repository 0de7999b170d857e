package nephele.engine.render.resource;

import nephele.engine.level.Sun;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.UniformBuffer;
import nephele.engine.render.gl.shader.UniformBlock;
import nephele.engine.scene.light.LightGrid;
import nephele.engine.scene.light.ShadowFrame;
import nephele.engine.scene.light.SkyIrradiance;

/** The uniform block {@code Light} of {@code light.glsl}: the light of a level. */
public final class LightBlock implements GlObject {
    private static final int SUN = 0;
    private static final int AMBIENT = 8;
    private static final int SUN_MAP = 12;
    private static final int LIGHT_GRID = 36;
    private static final int CLOUD_SHADE = 48;
    private static final int SKY = 56;
    private static final int PARTS = SKY + 4 * SkyIrradiance.TERMS;
    private static final int FLOATS = PARTS + 4;
    /** Only in levels with lightning. */
    private static final int FLASH = FLOATS;

    private static final int FLASH_FLOATS = 12;

    private final UniformBuffer buffer;
    private final float[] values;

    /** @param hasFlash whether there is lightning */
    public LightBlock(GlContext gl, boolean hasFlash) {
        values = new float[hasFlash ? FLOATS + FLASH_FLOATS : FLOATS];
        buffer = new UniformBuffer(gl, "light", values.length);
    }

    public void sun(Sun sun) {
        var towards = sun.directionTowardsSun().toVector().normalize();
        new Vec3(towards.x, towards.y, towards.z).put(values, SUN, 0);
        sun.irradiance().put(values, SUN + 4, 0);
    }

    public void ambient(Vec3 radiance) {
        radiance.put(values, AMBIENT, 0);
    }

    public void sunShadow(ShadowFrame frame) {
        frame.mapFromAnchor().get(values, SUN_MAP);
        double texelDepth = frame.texelMetres() / frame.depthMetres();
        frame.right().put(values, SUN_MAP + 16, texelDepth);
        frame.up().put(values, SUN_MAP + 20, (float) texelDepth / 2);
    }

    /** @param anchor the origin of positions in shaders */
    public void lightGrid(LightGrid grid, Vec3 anchor) {
        Vec3 cell = grid.cellMetres();
        grid.min().minus(anchor).put(values, LIGHT_GRID, 0);
        new Vec3(1 / cell.x(), 1 / cell.y(), 1 / cell.z()).put(values, LIGHT_GRID + 4, 0);
        new Vec3(grid.columns(), grid.floors(), grid.rows()).put(values, LIGHT_GRID + 8, 0);
    }

    /** @param region of the clouds' shade, relative to the anchor */
    public void cloudShade(Aabb region) {
        new Vec3(region.minX(), region.minY(), region.minZ()).put(values, CLOUD_SHADE, 0);
        new Vec3(
                        1 / (region.maxX() - region.minX()),
                        1 / (region.maxY() - region.minY()),
                        1 / (region.maxZ() - region.minZ()))
                .put(values, CLOUD_SHADE + 4, 0);
    }

    public void sky(SkyIrradiance sky) {
        double[] c = sky.coefficients();
        for (int i = 0; i < SkyIrradiance.TERMS; i++) {
            new Vec3(c[3 * i], c[3 * i + 1], c[3 * i + 2]).put(values, SKY + 4 * i, 0);
        }
    }

    /** @param weights of ambient, diffuse and specular light that are shown, 0 or 1 */
    public void parts(Vec3 weights) {
        weights.put(values, PARTS, 0);
    }

    /** @param anchor the origin of positions in shaders */
    public void flash(FrameLightning lightning, Vec3 anchor) {
        boolean isLit = lightning.isLit();
        Vec3 place = isLit ? lightning.middle().minus(anchor) : Vec3.ZERO;
        place.put(values, FLASH, isLit ? (float) lightning.softeningSquare() : 1);
        (isLit ? lightning.radiantIntensity() : Vec3.ZERO).put(values, FLASH + 4, 0);
        (isLit ? lightning.glow(anchor) : Vec3.ZERO).put(values, FLASH + 8, 0);
    }

    /** Uploads the values that were set. */
    public void upload() {
        buffer.upload(values);
    }

    public void bind() {
        buffer.bind(UniformBlock.LIGHT);
    }

    @Override
    public void close() {
        buffer.close();
    }
}
