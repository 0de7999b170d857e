package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.Picture;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.planted.PlantedModels;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.OwnedObjects;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.render.gl.shader.TextureUnit;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.impostor.ImpostorAtlas;
import nephele.engine.scene.impostor.KindShape;
import nephele.engine.scene.impostor.KindSky;
import org.lwjgl.system.MemoryUtil;

/** The kinds of plants on the GPU: their meshes, their atlases as layers of two textures, and their numbers. */
final class PlantedKinds implements GlObject {
    private static final int FLOATS = 16;

    private final OwnedObjects owned;
    private final List<KindShape> shapes = new ArrayList<>();
    private final List<KindMesh> meshes = new ArrayList<>();
    private final Texture colours;
    private final Texture normals;
    private final BufferTexture numbers;

    /** What is derived from a mesh without its material. */
    private record Form(KindShape shape, KindSky sky) {
        static Form of(PlantedModels.Kind kind) {
            KindShape shape = KindShape.of(kind);
            return new Form(shape, KindSky.of(shape));
        }
    }

    private record FormOf(Identity mesh, Object frame) {}

    private record AtlasOf(Identity form, Object material, Identity picture, ColourDecoding decoding, int texels) {}

    PlantedKinds(GlContext gl, List<PlantedModels.Kind> kinds, SceneMaterials materials, PlantSource source) {
        owned = new OwnedObjects(gl);
        int side = ImpostorAtlas.SIDE * source.texels();
        Texture.Extent extent = new Texture.Extent(side, side, Math.max(1, kinds.size()));
        colours = owned.own(new Texture(
                gl, "impostor colours", Texture.Shape.ARRAY, source.format(), extent, Sampling.MIPMAPPED_CLAMP));
        normals = owned.own(new Texture(
                gl, "impostor shapes", Texture.Shape.ARRAY, PixelFormat.RGBA8, extent, Sampling.MIPMAPPED_CLAMP));
        float[] values = new float[FLOATS * Math.max(1, kinds.size())];
        for (int i = 0; i < kinds.size(); i++) {
            PlantedModels.Kind kind = kinds.get(i);
            FormOf madeFrom = new FormOf(new Identity(kind.mesh()), kind.plantFromModel());
            Form form = owned.shareValue(Form.class, madeFrom, () -> Form.of(kind));
            Surface surface = materials.surfaces().get(materials.indexOf(kind.material()));
            Picture picture = picture(surface, materials);
            AtlasOf of = new AtlasOf(
                    new Identity(form), surface.material(), new Identity(picture), source.decoding(), source.texels());
            ImpostorAtlas atlas = owned.shareValue(
                    ImpostorAtlas.class,
                    of,
                    () -> ImpostorAtlas.of(
                            form.shape(), surface.material(), picture, source.decoding(), source.texels()));
            upload(i, atlas);
            shapes.add(form.shape());
            meshes.add(owned.own(new KindMesh(gl, form.shape(), form.sky(), surface)));
            put(form, surface.material().emission(), FLOATS * i, values);
        }
        numbers = owned.own(BufferTexture.ofFloats(gl, "plant kinds", values));
    }

    private static Picture picture(Surface surface, SceneMaterials materials) {
        int array = surface.colour().array();
        return array < 0
                ? null
                : materials
                        .colourArrays()
                        .get(array)
                        .layers()
                        .get(surface.colour().layer());
    }

    private static void put(Form form, Vec3 emission, int at, float[] values) {
        KindShape shape = form.shape();
        shape.centre().put(values, at, shape.halfWidth());
        values[at + 4] = (float) shape.halfHeight();
        values[at + 5] = (float) shape.radius();
        System.arraycopy(form.sky().fit(), 0, values, at + 8, 4);
        emission.put(values, at + 12, 0);
    }

    private void upload(int layer, ImpostorAtlas atlas) {
        ByteBuffer texels = MemoryUtil.memAlloc(4 * atlas.side() * atlas.side());
        try {
            for (int level = 0; level < atlas.colours().size(); level++) {
                colours.uploadLevel(
                        level,
                        layer,
                        texels.clear().put(atlas.colours().get(level)).flip());
                normals.uploadLevel(
                        level,
                        layer,
                        texels.clear().put(atlas.shapes().get(level)).flip());
            }
        } finally {
            MemoryUtil.memFree(texels);
        }
    }

    KindShape shape(int kind) {
        return shapes.get(kind);
    }

    List<KindMesh> meshes() {
        return meshes;
    }

    void bindNumbers() {
        numbers.bind(TextureUnit.PLANT_KINDS);
    }

    void bindAtlases() {
        colours.bind(TextureUnit.COLOURS);
        normals.bind(TextureUnit.IMPOSTOR_SHAPES);
    }

    @Override
    public void close() {
        owned.close();
    }
}
