package nephele.workshop.art;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import nephele.engine.model.file.MeshText;
import nephele.lab.generate.PlantKind;
import nephele.lab.generate.PlantPaint;
import nephele.lab.generate.TerrainGenerator;
import nephele.workshop.art.bench.BenchLevels;
import nephele.workshop.art.bench.BenchPixels;
import nephele.workshop.art.bench.BenchTerrain;
import nephele.workshop.art.material.TextureRecipe;
import nephele.workshop.art.paint.ColourRamp;
import nephele.workshop.art.paint.Pixels;
import nephele.workshop.art.paint.Surface;
import nephele.workshop.art.picture.PictureRecipe;
import nephele.workshop.art.picture.ScenePictures;
import nephele.workshop.art.picture.SignPainter;
import nephele.workshop.art.picture.SkyPainter;
import nephele.workshop.art.sprite.CloudPictures;
import nephele.workshop.art.sprite.SpritePictures;

/** Regenerates the pictures, meshes and grids below {@code assets/} and the benchmark levels: {@code gradle textures}. */
public final class ArtFiles {
    /** The meshes' folder below {@code assets/}. */
    public static final String PLANT_FOLDER = "models/plants";

    public static final List<PictureRecipe> PLANT_PICTURES =
            List.of(new PictureRecipe(PlantPaint.FILE, ArtFiles::plantPalette));
    private static final long PLANT_SEED = 1;
    private static final int PALETTE_TEXELS = 128;

    private static final int HEADER_BYTES = 18;
    private static final byte TRUE_COLOUR = 2;
    private static final byte BITS = 24;

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
        for (TextureRecipe recipe : TextureRecipe.ALL) {
            Surface surface = recipe.paint();
            write(assets.resolve(recipe.colourFile()), surface.colourPicture());
            write(assets.resolve(recipe.normalFile()), surface.normalPicture());
        }
        for (List<PictureRecipe> recipes :
                List.of(ScenePictures.ALL, CloudPictures.ALL, PLANT_PICTURES, SpritePictures.ALL, StonesMap.GROWTH)) {
            for (PictureRecipe recipe : recipes) {
                write(assets.resolve(recipe.file()), recipe.painter().get());
            }
        }
        for (int face = 0; face < 6; face++) {
            write(assets.resolve(SkyPainter.files().get(face)), new SkyPainter().face(face));
        }
        write(assets.resolve(SkyPainter.CROSS_FILE), new SkyPainter().cross());
        for (Map.Entry<String, BufferedImage> picture : SkyPainter.layouts().entrySet()) {
            write(assets.resolve(picture.getKey()), picture.getValue());
        }
        write(assets.resolve(SignPainter.FILE), SignPainter.paint());
        Files.write(assets.resolve(BenchTerrain.MAP), TerrainGenerator.png(BenchTerrain.map(), BenchTerrain.SIDE));
        Files.write(assets.resolve(StonesMap.FILE), TerrainGenerator.png(StonesMap.heights(), StonesMap.SIDE));
        for (Map.Entry<String, byte[]> sample : SampleFiles.all().entrySet()) {
            Path file = assets.resolve(sample.getKey());
            Files.createDirectories(file.getParent());
            Files.write(file, sample.getValue());
        }
        Files.createDirectories(assets.resolve(PLANT_FOLDER));
        for (Map.Entry<String, byte[]> mesh : plants().entrySet()) {
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
            Files.write(file, tga(picture));
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

    /** Writes Truevision TGA files of 24 bits a pixel, uncompressed, from the lowest row, as games' tools write them. */
    private static byte[] tga(BufferedImage picture) {
        int width = picture.getWidth();
        int height = picture.getHeight();
        ByteBuffer file = ByteBuffer.allocate(HEADER_BYTES + 3 * width * height).order(ByteOrder.LITTLE_ENDIAN);
        file.put(2, TRUE_COLOUR).putShort(12, (short) width).putShort(14, (short) height);
        file.put(16, BITS).position(HEADER_BYTES);
        for (int y = height - 1; y >= 0; y--) {
            for (int x = 0; x < width; x++) {
                int rgb = picture.getRGB(x, y);
                file.put((byte) rgb).put((byte) (rgb >> 8)).put((byte) (rgb >> 16));
            }
        }
        return file.array();
    }

    /** The files of plants and rocks that ship, one mesh a kind and the palette that all share. */
    private static BufferedImage plantPalette() {
        PlantPaint[] all = PlantPaint.values();
        return Pixels.picture(PALETTE_TEXELS, PALETTE_TEXELS, (column, row) -> {
            PlantPaint paint = all[Math.min(row * PlantPaint.ROWS / PALETTE_TEXELS, all.length - 1)];
            double place = ((column + 0.5) / PALETTE_TEXELS - PlantPaint.MARGIN) / (1 - 2 * PlantPaint.MARGIN);
            return ColourRamp.of(paint.darkToLight()).at(Math.max(0, place)).rgb();
        });
    }

    /** Returns the meshes by asset id. */
    public static Map<String, byte[]> plants() {
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (PlantKind kind : PlantKind.all()) {
            files.put(PLANT_FOLDER + "/" + kind.word() + ".3d", MeshText.of(kind.grown(PLANT_SEED)));
        }
        return files;
    }
}
