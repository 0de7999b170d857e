package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.appearance.ShaftLight;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.View;
import org.lwjgl.system.MemoryUtil;

/**
 * The share of the air's light that clouds take, by pixel and distance, for each view of a frame; {@code air.glsl} reads
 * it. A view without a table has no shafts, such as one that shows only the sky.
 */
public final class ShaftTables implements GlObject {
    public static final SharedResource<ShaftTables> RESOURCE = SharedResource.of("shafts", ShaftTables::of)
            .following((tables, frame) -> tables.used = 0)
            .inViews(ShaftTables::setView);

    /** Pixels of a view along each side of one of its table. */
    public static final int DIVISOR = 8;

    /** Each has four distances. */
    public static final int LAYERS = 4;

    private final GlContext gl;
    private final Texture none;
    private final List<Table> tables = new ArrayList<>();
    /** Tables of views of this frame; the others are free. */
    private int used;

    private static final class Table {
        private final Texture texture;
        private final RenderTarget target;
        private View view;

        private Table(Texture texture, RenderTarget target) {
            this.texture = texture;
            this.target = target;
        }
    }

    private ShaftTables(GlContext gl) {
        this.gl = gl;
        none = layers("no shafts", 1, 1);
        ByteBuffer zeros = MemoryUtil.memCalloc(4 * Float.BYTES);
        for (int layer = 0; layer < LAYERS; layer++) {
            none.upload(layer, zeros.clear());
        }
        MemoryUtil.memFree(zeros);
    }

    private Texture layers(String name, int width, int height) {
        var extent = new Texture.Extent(width, height, LAYERS);
        return new Texture(gl, name, Texture.Shape.ARRAY, PixelFormat.RGBA16F, extent, Sampling.LINEAR_CLAMP);
    }

    /** Returns {@code null} if no cloud shades the air. */
    private static ShaftTables of(LoadContext context) {
        return ShaftLight.isIn(context.scene().level().environment())
                ? context.own(new ShaftTables(context.gl()))
                : null;
    }

    /** Binds the table of a view for the following draws. */
    public void setView(View view) {
        Table table = of(view);
        (table == null ? none : table.texture).bind(TextureUnit.SHAFTS);
    }

    private Table of(View view) {
        for (int i = 0; i < used; i++) {
            if (tables.get(i).view == view) {
                return tables.get(i);
            }
        }
        return null;
    }

    /** Returns the target of a view's table; it must be drawn before it is read. */
    public RenderTarget target(View view, RenderTarget surface) {
        Table table = of(view);
        if (table == null) {
            table = take(fewer(surface.width()), fewer(surface.height()));
            table.view = view;
        }
        return table.target;
    }

    private static int fewer(int pixels) {
        return (pixels + DIVISOR - 1) / DIVISOR;
    }

    private Table take(int width, int height) {
        if (used < tables.size()) {
            Table free = tables.get(used);
            if (free.target.width() == width && free.target.height() == height) {
                used++;
                return free;
            }
            close(free);
            tables.remove(used);
        }
        Texture texture = layers("shafts", width, height);
        Table made = new Table(
                texture,
                RenderTarget.colourLayers(
                        gl, "shafts", texture, 0, texture.extent().layers()));
        tables.add(used++, made);
        return made;
    }

    private static void close(Table table) {
        table.target.close();
        table.texture.close();
    }

    @Override
    public void close() {
        tables.forEach(ShaftTables::close);
        none.close();
    }
}
