package nephele.workshop.art;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.lab.generate.TerrainFile;
import nephele.workshop.art.bench.BenchLevels;
import nephele.workshop.art.bench.BenchPixels;
import nephele.workshop.art.bench.BenchTerrain;
import nephele.workshop.art.material.TextureRecipe;
import nephele.workshop.art.material.Textures;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.picture.PictureRecipe;
import nephele.workshop.art.picture.ScenePictures;
import nephele.workshop.art.picture.SignPainter;
import nephele.workshop.art.picture.SkyLayouts;
import nephele.workshop.art.picture.SkyPainter;
import nephele.workshop.art.sprite.CloudPictures;
import nephele.workshop.art.sprite.SampleGrid;
import nephele.workshop.art.sprite.SpritePictures;

/** Regenerates the pictures, meshes and grids below {@code assets/} and the benchmark levels: {@code gradle textures}. */
public final class ArtFiles {
    private ArtFiles() {}

    /** @param arguments the checkout's root, default the working directory */
    public static void main(String[] arguments) throws IOException {
        Path root = Path.of(arguments.length > 0 ? arguments[0] : "");
        for (Map.Entry<String, Level> level : BenchLevels.all().entrySet()) {
            Path file = root.resolve("levels/bench").resolve(level.getKey());
            Files.writeString(file, LevelJson.write(level.getValue()));
        }
        Path assets = root.resolve("assets");
        for (Map.Entry<String, BufferedImage> picture : benchPictures().entrySet()) {
            write(assets.resolve(picture.getKey()), picture.getValue());
        }
        for (TextureRecipe recipe : Textures.ALL) {
            Surface surface = recipe.paint();
            write(assets.resolve(recipe.colourFile()), surface.colourPicture());
            write(assets.resolve(recipe.normalFile()), surface.normalPicture());
        }
        for (PictureRecipe recipe : ScenePictures.ALL) {
            write(assets.resolve(recipe.file()), recipe.painter().get());
        }
        for (PictureRecipe recipe : CloudPictures.ALL) {
            write(assets.resolve(recipe.file()), recipe.painter().get());
        }
        for (PictureRecipe recipe : PlantFiles.PICTURES) {
            write(assets.resolve(recipe.file()), recipe.painter().get());
        }
        for (PictureRecipe recipe : SpritePictures.ALL) {
            write(assets.resolve(recipe.file()), recipe.painter().get());
        }
        for (PictureRecipe recipe : StonesGrowth.PICTURES) {
            write(assets.resolve(recipe.file()), recipe.painter().get());
        }
        for (int face = 0; face < 6; face++) {
            write(assets.resolve(SkyPainter.files().get(face)), new SkyPainter().face(face));
        }
        write(assets.resolve(SkyPainter.CROSS_FILE), new SkyPainter().cross());
        for (Map.Entry<String, BufferedImage> picture : SkyLayouts.all().entrySet()) {
            write(assets.resolve(picture.getKey()), picture.getValue());
        }
        write(assets.resolve(SignPainter.FILE), SignPainter.paint());
        Files.write(assets.resolve(BenchTerrain.MAP), TerrainFile.png(BenchTerrain.map(), BenchTerrain.SIDE));
        Files.write(assets.resolve(StonesMap.FILE), TerrainFile.png(StonesMap.heights(), StonesMap.SIDE));
        Path grid = assets.resolve(SampleGrid.FILE);
        Files.createDirectories(grid.getParent());
        Files.write(grid, SampleGrid.written());
        for (Map.Entry<String, byte[]> mesh : SampleMeshes.all().entrySet()) {
            Files.write(assets.resolve(mesh.getKey()), mesh.getValue());
        }
        Files.createDirectories(assets.resolve(PlantFiles.FOLDER));
        for (Map.Entry<String, byte[]> mesh : PlantFiles.meshes().entrySet()) {
            Files.write(assets.resolve(mesh.getKey()), mesh.getValue());
        }
    }

    /** Returns the pictures of the benchmark levels by asset id. */
    static Map<String, BufferedImage> benchPictures() {
        Map<String, BufferedImage> pictures = new LinkedHashMap<>();
        pictures.put("textures/bench/box.png", BenchPixels.box());
        pictures.put("textures/bench/ground.png", BenchPixels.ground());
        pictures.put("textures/bench/tree.png", BenchPixels.tree());
        for (int face = 0; face < 6; face++) {
            pictures.put(BenchLevels.skyFiles().get(face), BenchPixels.sky(face));
        }
        return pictures;
    }

    /** Writes a picture in the format of the file's extension: PNG, BMP or TGA. */
    private static void write(Path file, BufferedImage picture) throws IOException {
        Files.createDirectories(file.getParent());
        String name = file.getFileName().toString();
        if (name.endsWith(".tga")) {
            Files.write(file, TgaFile.written(picture));
        } else if (name.endsWith(".bmp")) {
            ImageIO.write(picture, "bmp", file.toFile());
        } else {
            writePng(file, picture);
        }
    }

    private static void writePng(Path file, BufferedImage picture) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("png").next();
        ImageWriteParam smallest = writer.getDefaultWriteParam();
        smallest.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        smallest.setCompressionQuality(0);
        try (OutputStream out = Files.newOutputStream(file);
                ImageOutputStream stream = ImageIO.createImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(picture, null, null), smallest);
        } finally {
            writer.dispose();
        }
    }
}
