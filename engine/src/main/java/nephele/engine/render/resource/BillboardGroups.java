package nephele.engine.render.resource;

import java.nio.FloatBuffer;
import java.util.List;
import nephele.engine.level.Billboards;
import nephele.engine.level.billboard.Sway;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.shader.TextureUnit;
import org.lwjgl.system.MemoryUtil;

/** What all billboards of a group share, for {@code billboard.glsl}; uploaded again when time moves any of them. */
final class BillboardGroups implements GlObject {
    /** Five texels a group. */
    private static final int FLOATS = 20;

    private final List<Billboards> groups;
    private final BillboardSprites sprites;
    private final BufferTexture texels;
    private final FloatBuffer values;
    private final boolean moves;
    private double shown = Double.NaN;

    BillboardGroups(GlContext gl, List<Billboards> groups, BillboardSprites sprites) {
        this.groups = groups;
        this.sprites = sprites;
        moves = groups.stream().anyMatch(Billboards::moves);
        texels = BufferTexture.changing(gl, "billboard groups");
        values = MemoryUtil.memAllocFloat(FLOATS * Math.max(1, groups.size()));
    }

    /** Moves the groups to a time. */
    void follow(double seconds) {
        if (seconds == shown || !moves && !Double.isNaN(shown)) {
            return;
        }
        shown = seconds;
        values.clear();
        for (Billboards group : groups) {
            double wind = group.windMetresPerSecond();
            put(
                    group.sizeMetres().width(),
                    group.sizeMetres().height(),
                    group.facing().ordinal(),
                    sprites.place(group).layer());
            put(frame(group, seconds), group.frames(), group.framesPerSecond() > 0 ? 1 : 0, 0);
            put(Sway.lean(wind), Sway.SWINGING, Sway.turns(seconds), Sway.turnsPerMetre(wind));
            put(group.colour() == null ? Vec3.ZERO : group.colour(), group.colour() == null ? 0 : 1);
            put(group.emission(), 0);
        }
        texels.upload(values.flip());
    }

    /** Returns the frame at a time, from 0 to less than the number of frames; exact after years. */
    private static double frame(Billboards group, double seconds) {
        double rounds = seconds * group.framesPerSecond() / group.frames();
        return (rounds - Math.floor(rounds)) * group.frames();
    }

    private void put(Vec3 v, double w) {
        put(v.x(), v.y(), v.z(), w);
    }

    private void put(double x, double y, double z, double w) {
        values.put((float) x).put((float) y).put((float) z).put((float) w);
    }

    void bind() {
        texels.bind(TextureUnit.BILLBOARD_GROUPS);
    }

    @Override
    public void close() {
        texels.close();
        MemoryUtil.memFree(values);
    }
}
