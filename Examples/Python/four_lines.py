import marrow
camel = marrow.read("meshes/camel.off", segments="animals/camel.seg")
cow = marrow.transfer(camel, marrow.read("meshes/cow.off"))
marrow.write(cow, "cow.vtp")
