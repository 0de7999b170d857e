package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.PngEncoder;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.billboard.PlantedModels.Plant;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.scene.impostor.ImpostorAtlas;
import nephele.engine.scene.impostor.KindShape;
import org.joml.Vector3d;

/**
 * The impostors of a level as billboards: at the same places, as large, with a picture of the mesh from one side.
 *
 * @param groups one for each model of the level that is drawn as impostors
 * @param assets the level's and the pictures
 */
record PlantSprites(List<Billboards> groups, AddedAssets assets) {
    /** The side of a picture with its border, more than the pixels of the largest tree in a report. */
    private static final int TEXELS = 512;

    static PlantSprites of(PlacedLevel placed) {
        PlantedModels planted = PlantedModels.of(placed.level(), placed.statics(), placed.assets());
        List<KindShape> shapes = planted.kinds().stream().map(KindShape::of).toList();
        Map<String, byte[]> files = new HashMap<>();
        List<Billboards> groups = new ArrayList<>();
        for (int i = 0; i < placed.level().models().size(); i++) {
            int model = i;
            List<Plant> plants = planted.plants().stream()
                    .filter(plant -> plant.model() == model)
                    .toList();
            if (!plants.isEmpty()) {
                int kind = plants.get(0).kind();
                String file = "sprite-" + kind + ".png";
                files.computeIfAbsent(
                        file,
                        made -> PngEncoder.file(
                                picture(shapes.get(kind), planted.kinds().get(kind), placed)));
                groups.add(group(placed.level().models().get(i), plants, shapes.get(kind), file));
            }
        }
        return new PlantSprites(List.copyOf(groups), new AddedAssets(placed.assets(), Map.copyOf(files)));
    }

    private static Picture picture(KindShape shape, PlantedModels.Kind kind, PlacedLevel placed) {
        Material material = placed.level().materials().stream()
                .filter(each -> each.id().equals(kind.material()))
                .findFirst()
                .orElse(Material.DEFAULT_GREY);
        String file = material.texture();
        Picture texture = file == null
                ? null
                : PictureDecoder.decode(file, placed.assets().bytes(file)).toRgba8();
        return ImpostorAtlas.sprite(shape, material, texture, ColourDecoding.SRGB, TEXELS);
    }

    /** Returns billboards of the model's own id: sizes of a field are random by it and the number of the place. */
    private static Billboards group(ModelPlacement model, List<Plant> plants, KindShape shape, String file) {
        double scale = model.isPlanted() ? 1 : plants.get(0).scale();
        Vec3 base = shape.centre().minus(new Vec3(0, shape.halfHeight(), 0));
        return new Billboards(
                model.id(),
                file,
                null,
                Facing.CYLINDRICAL,
                new Billboards.Size(2 * scale * shape.halfWidth(), 2 * scale * shape.halfHeight()),
                model.heightVariation(),
                plants.stream().map(plant -> at(plant, base)).toList(),
                null,
                1,
                0,
                0,
                false,
                Vec3.ZERO,
                null);
    }

    private static Vec3 at(Plant plant, Vec3 point) {
        Vector3d at = plant.worldFromPlant().transformPosition(new Vector3d(point.x(), point.y(), point.z()));
        return new Vec3(at.x, at.y, at.z);
    }

    /** Returns a level with billboards instead of impostors. */
    Level in(Level level, Facing facing) {
        List<ModelPlacement> others =
                level.models().stream().filter(model -> !model.impostor()).toList();
        List<Billboards> all = new ArrayList<>(level.billboards());
        groups.forEach(group -> all.add(group.turned(facing)));
        return level.with(level.materials(), level.solids(), level.bodies(), others)
                .withBillboards(List.copyOf(all));
    }
}
