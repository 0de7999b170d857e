package nephele.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.FileName;
import nephele.engine.asset.HeightMap;
import nephele.engine.model.file.MeshText;
import nephele.engine.model.shape.BezierPatches;
import nephele.engine.model.shape.BezierShape;
import nephele.engine.model.shape.PlaneShape;
import nephele.engine.model.shape.Shape;
import nephele.engine.model.shape.ShapeKind;
import nephele.engine.model.shape.ShapeParameter;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.lab.generate.PlantKind;
import nephele.lab.generate.PlantKind.Family;
import nephele.lab.generate.TerrainGenerator;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Makes a mesh (a primitive, a Bézier surface, a tree or a rock) or a height map. */
@picocli.CommandLine.Command(
        customSynopsis = {
            "nephele generate plane LENGTH DIVISIONS [--two-sided] OUT.3d",
            "       nephele generate box LENGTH DIVISIONS OUT.3d",
            "       nephele generate cone RADIUS HEIGHT SLICES STACKS OUT.3d",
            "       nephele generate sphere RADIUS SLICES STACKS OUT.3d",
            "       nephele generate cylinder RADIUS HEIGHT SLICES OUT.3d",
            "       nephele generate torus RADIUS TUBE SLICES STACKS OUT.3d",
            "       nephele generate patch FILE.patch TESSELLATION OUT.3d",
            "       nephele generate tree KIND SEED OUT.3d",
            "       nephele generate rock KIND SEED OUT.3d",
            "       nephele generate terrain SEED SIZE OUT.png"
        },
        footer = {
            "",
            "LENGTH        of a side, in units",
            "RADIUS        in units; of a torus, to the middle of the tube",
            "HEIGHT        in units",
            "TUBE          radius of the tube, less than RADIUS",
            "DIVISIONS     parts of a side, 1 to 512",
            "SLICES        parts of the circle around the y axis, 3 to 512",
            "STACKS        parts from bottom to top or around the tube, 1 (sphere 2, torus 3) to 512",
            "TESSELLATION  parts of each side of a Bézier patch, 1 to 512",
            "SEED          whole number; each makes another landscape",
            "SIZE          heights along a side of a height map, 2 to 8193",
            "",
            "KIND          of tree: oak, birch, fir, cypress, bush, fern or grass; of rock: boulder or ledge",
            "SEED          a whole number; each gives another tree or rock",
            "",
            "Trees and rocks stand on the xz plane and take their colours from textures/plants.png.",
            "Other meshes are centred at the origin; a cone stands on the xz plane.",
            "docs/models.md has the formats."
        })
final class GenerateCommand implements Command {
    private static final int LARGEST_PATCHES = 64 << 20;

    @Parameters(arity = "1..*", hidden = true, paramLabel = "SHAPE NUMBER... OUT.3d")
    private List<String> words;

    @Option(names = "--two-sided", description = "Give a plane a face downward as well.")
    private boolean twoSided;

    @Override
    public ExitCode run(Terminal terminal) {
        String kind = words.get(0);
        if (kind.equals("terrain")) {
            return terrain();
        }
        Optional<Family> family = Family.named(kind);
        boolean patch = kind.equals("patch");
        if (family.isEmpty() && !patch && ShapeKind.named(kind).isEmpty()) {
            throw CommandFailure.usage(kind
                    + " is no shape: use plane, box, cone, sphere, cylinder, torus, patch, tree, rock or terrain. "
                    + help());
        }
        if (words.size() < 3) {
            throw CommandFailure.usage(kind + " needs numbers and a file to write. " + help());
        }
        Path out = out();
        List<String> numbers = words.subList(1, words.size() - 1);
        byte[] text = family.isPresent()
                ? grown(family.get(), numbers)
                : text(patch ? patch(numbers) : primitive(ShapeKind.named(kind).get(), numbers));
        WrittenFile.write(out, file -> AtomicFile.write(file, text));
        return ExitCode.DONE;
    }

    private ExitCode terrain() {
        if (words.size() != 4 || twoSided) {
            throw CommandFailure.usage("terrain takes SEED, SIZE and the file to write. " + help());
        }
        int seed = whole("SEED", words.get(1), Integer.MIN_VALUE, Integer.MAX_VALUE);
        int side = whole("SIZE", words.get(2), HeightMap.LEAST_SAMPLES, HeightMap.MOST_SAMPLES);
        Path out = out(".png");
        byte[] picture = TerrainGenerator.png(TerrainGenerator.heights(seed, side), side);
        WrittenFile.write(out, file -> AtomicFile.write(file, picture));
        return ExitCode.DONE;
    }

    private static int whole(String name, String text, int least, int most) {
        try {
            long number = Long.parseLong(text);
            if (number >= least && number <= most) {
                return (int) number;
            }
        } catch (NumberFormatException noNumber) {
            // Reported below, as a number out of range is.
        }
        throw CommandFailure.usage(name + " is a whole number from " + least + " to " + most + ", not " + text);
    }

    private Path out() {
        return out(".3d");
    }

    private Path out(String ending) {
        String name = words.get(words.size() - 1);
        if (!name.endsWith(ending)) {
            throw CommandFailure.usage("the last word names the file to write and ends in " + ending + ", not " + name);
        }
        return path(name);
    }

    private Shape primitive(ShapeKind kind, List<String> numbers) {
        Shape shape = usage(() -> kind.shape(numbers));
        if (!twoSided) {
            return shape;
        }
        if (!(shape instanceof PlaneShape plane)) {
            throw CommandFailure.usage("--two-sided belongs to plane: a " + kind.word() + " has no second side");
        }
        return new PlaneShape(plane.length(), plane.divisions(), true);
    }

    private byte[] grown(Family family, List<String> words) {
        if (words.size() != 2 || twoSided) {
            throw CommandFailure.usage(family.word() + " takes KIND, SEED and the file to write. " + help());
        }
        PlantKind kind = PlantKind.named(family, words.get(0))
                .orElseThrow(() -> CommandFailure.usage(words.get(0) + " is no kind of " + family.word() + ": use "
                        + PlantKind.words(family) + ". " + help()));
        return MeshText.of(kind.grown(seed(words.get(1))));
    }

    private static long seed(String word) {
        try {
            return Long.parseLong(word);
        } catch (NumberFormatException noNumber) {
            throw CommandFailure.usage(
                    "SEED is a whole number from " + Long.MIN_VALUE + " to " + Long.MAX_VALUE + ", not " + word);
        }
    }

    private Shape patch(List<String> numbers) {
        if (numbers.size() != 2 || twoSided) {
            throw CommandFailure.usage("patch takes a file, TESSELLATION and the file to write. " + help());
        }
        int tessellation = usage(() -> (int) ShapeParameter.TESSELLATION.read(numbers.get(1)));
        BezierPatches patches = patches(numbers.get(0));
        return usage(() -> new BezierShape(patches, tessellation));
    }

    private static BezierPatches patches(String file) {
        try {
            return BezierPatches.read(file, AtomicFile.read(path(file), LARGEST_PATCHES));
        } catch (IOException missing) {
            throw CommandFailure.input(file + ": can't be read: " + AtomicFile.reason(missing));
        }
    }

    private static byte[] text(Shape shape) {
        return usage(() -> MeshText.of(shape.mesh()));
    }

    private static Path path(String file) {
        String objection = FileName.objection(file);
        if (objection != null) {
            throw CommandFailure.usage(FileName.printable(file) + ": " + objection);
        }
        return Path.of(file);
    }

    /** Reports an illegal argument, which the numbers caused, as wrong usage. */
    private static <T> T usage(Supplier<T> made) {
        try {
            return made.get();
        } catch (IllegalArgumentException wrong) {
            throw CommandFailure.usage(wrong.getMessage());
        }
    }

    private static String help() {
        return "`nephele generate --help` has them all.";
    }
}
