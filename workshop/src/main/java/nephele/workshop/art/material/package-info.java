/** The textures of the game's materials, each a recipe that paints colour and normals. */
package nephele.workshop.art.material;
