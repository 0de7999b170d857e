/** Generators of the game's art: textures, skies, meshes and benchmark levels. */
package nephele.workshop.art;
